# The modules _core and _occt, for the Python and the OpenCASCADE that FreeCAD itself runs on, and the addon's layout.

# A FreeCAD of a conda environment, or one that was built and installed by hand, brings all that it runs on in its prefix.
set(FREECAD_PREFIX "" CACHE PATH "the prefix of the FreeCAD to build for, when it is not the system's: FREECAD_PREFIX/bin/freecadcmd")
if(FREECAD_PREFIX)
  list(PREPEND CMAKE_PREFIX_PATH ${FREECAD_PREFIX})
  find_program(FREECADCMD NAMES freecadcmd FreeCADCmd HINTS ${FREECAD_PREFIX}/bin NO_DEFAULT_PATH)
else()
  find_program(FREECADCMD NAMES freecadcmd FreeCADCmd)
endif()
if(NOT FREECADCMD)
  message(FATAL_ERROR "FreeCAD's console program was not found: name the folder above its bin with -DFREECAD_PREFIX=..., "
    "the program itself with -DFREECADCMD=..., or build the core alone with -DEVENLOAD_PYTHON=OFF.")
endif()

# FreeCAD is asked in a home of its own, so that the question leaves nothing in the user's.
set(scratch ${CMAKE_BINARY_DIR}/ask_freecad)
file(MAKE_DIRECTORY ${scratch})
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env --unset=PYTHONPATH --unset=PYTHONHOME HOME=${scratch} FREECAD_USER_HOME=${scratch}
    ${FREECADCMD} ${CMAKE_CURRENT_LIST_DIR}/ask_freecad.py
  INPUT_FILE /dev/null OUTPUT_VARIABLE answers ERROR_VARIABLE errors TIMEOUT 120)
file(REMOVE_RECURSE ${scratch})
if(NOT answers MATCHES "EVENLOAD occt=")
  message(FATAL_ERROR "${FREECADCMD} did not answer which Python and OpenCASCADE it uses:\n${answers}\n${errors}")
endif()
file(REAL_PATH ${FREECADCMD} freecad_program)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${freecad_program})
foreach(name suffix python occt)
  string(REGEX MATCH "EVENLOAD ${name}=([^\r\n]*)" line "${answers}")
  set(freecad_${name} "${CMAKE_MATCH_1}")
endforeach()

# Another python3 may come first on PATH: FreeCAD's own is the default.
if(NOT Python3_EXECUTABLE)
  set(Python3_EXECUTABLE ${freecad_python})
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
execute_process(
  COMMAND ${Python3_EXECUTABLE} -c "import sysconfig; print(sysconfig.get_config_var('EXT_SUFFIX'))"
  OUTPUT_VARIABLE PYTHON_SUFFIX OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT PYTHON_SUFFIX STREQUAL freecad_suffix)
  message(FATAL_ERROR "FreeCAD loads modules named *${freecad_suffix}, but ${Python3_EXECUTABLE} makes *${PYTHON_SUFFIX}: "
    "name FreeCAD's own Python with -DPython3_EXECUTABLE=${freecad_python}.")
endif()
find_package(pybind11 REQUIRED)

# The parts that are used and no others, because the files for a whole OpenCASCADE may name libraries that are not installed.
find_package(OpenCASCADE REQUIRED COMPONENTS FoundationClasses ModelingData ModelingAlgorithms)
if(NOT OpenCASCADE_VERSION STREQUAL freecad_occt)
  message(FATAL_ERROR "FreeCAD runs on OpenCASCADE ${freecad_occt}, but the one found to build with is ${OpenCASCADE_VERSION}: "
    "name FreeCAD's own with -DOpenCASCADE_DIR=/path/to/its/cmake/folder.")
endif()

file(GLOB binding_sources CONFIGURE_DEPENDS src/python/*.cpp)
pybind11_add_module(_core MODULE NO_EXTRAS ${binding_sources})
target_link_libraries(_core PRIVATE evenload_core Eigen3::Eigen)
# They hand values over, which is no quicker at -O3: the work is done in the core.
target_compile_options(_core PRIVATE $<$<CONFIG:Release>:-O1>)
unite(_core)
precompile(_core <array> <optional> <string> <tuple> <vector> <pybind11/functional.h> <pybind11/numpy.h> <pybind11/pybind11.h>
  <pybind11/stl.h>)

file(GLOB occt_sources CONFIGURE_DEPENDS src/occt/*.cpp)
pybind11_add_module(_occt MODULE NO_EXTRAS ${occt_sources})
target_include_directories(_occt SYSTEM PRIVATE ${OpenCASCADE_INCLUDE_DIR})
target_link_libraries(_occt PRIVATE evenload_core TKernel TKMath TKG3d TKGeomBase TKBRep TKTopAlgo TKMesh)
# Modules for several FreeCADs lie in one folder: Python's suffix tells its version, the name OpenCASCADE's.
string(REPLACE "." "_" occt_module "_occt_${freecad_occt}")
set_target_properties(_occt PROPERTIES OUTPUT_NAME ${occt_module})
target_compile_definitions(_occt PRIVATE EVENLOAD_OCCT_MODULE=${occt_module})

# What FreeCAD loads, and nothing else.
install(FILES package.xml Init.py InitGui.py LICENSE README.md DESTINATION .)
install(DIRECTORY Mod Resources DESTINATION . PATTERN __pycache__ EXCLUDE PATTERN "*.so" EXCLUDE PATTERN "*.ts" EXCLUDE)
# The documentation, which F1 and What's This open, as HTML.
install(CODE "execute_process(COMMAND \"${Python3_EXECUTABLE}\" \"${CMAKE_SOURCE_DIR}/docs/html_pages.py\"
  \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/docs\" COMMAND_ERROR_IS_FATAL ANY)")
install(TARGETS _core _occt LIBRARY DESTINATION Mod/evenload)
