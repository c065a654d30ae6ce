# The C++ tests: one program, which ctest runs once for each pocket of the corpus and once for each other test.

find_package(GTest REQUIRED)
include(GoogleTest)

# The judge of paths looks at millions of points: it is built for speed, and without the sanitizers, which shall look at the core.
add_library(evenload_judge STATIC tests/cpp/judge/path_check.cpp)
target_compile_options(evenload_judge PRIVATE -O2 -fno-sanitize=all)
target_link_libraries(evenload_judge PUBLIC evenload_core)
target_include_directories(evenload_judge PUBLIC tests/cpp)

file(GLOB test_sources CONFIGURE_DEPENDS tests/cpp/*/*.cpp tests/cpp/strategy/*/*.cpp)
list(REMOVE_ITEM test_sources ${CMAKE_SOURCE_DIR}/tests/cpp/judge/path_check.cpp)
add_executable(evenload_tests ${test_sources})
target_link_libraries(evenload_tests PRIVATE evenload_judge evenload_core GTest::gmock GTest::gtest_main Boost::headers
  Eigen3::Eigen)
target_compile_definitions(evenload_tests PRIVATE EVENLOAD_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
# Most of a test's time passes in the core, so tests run about as fast however they are compiled: -O1 takes half the time of -O3,
# and where sanitizers or counters are added to each line -O0 takes half that of -O1.
target_compile_options(evenload_tests PRIVATE $<IF:$<CONFIG:Release>,-O1,-O0>)
unite(evenload_tests)
precompile(evenload_tests <algorithm> <cmath> <cstdio> <functional> <optional> <random> <string> <vector> <gmock/gmock.h>
  <gtest/gtest.h>)

# All tests of one pocket share a process, and with it the path and what the judge found. Six that take long are left to
# ./run test --slow; others of their kinds stay: gaps that widen, the pentagon, slot62, the ring, the star, the acute corner.
set(slow_pockets gap_at_30_degrees polygon_at_18_degrees slot62_at_30_degrees ring_at_56_degrees blob_at_33_degrees
  wedge_at_31_degrees)
file(GLOB pockets CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/tests/corpus tests/corpus/*.json)
set(others "-Slow*")
foreach(file ${pockets})
  string(REPLACE .json "" pocket ${file})
  add_test(NAME Pocket.${pocket} COMMAND evenload_tests --gtest_filter=Pocket/*/${pocket})
  # GoogleTest is content with a filter that no test matches.
  set_tests_properties(Pocket.${pocket} PROPERTIES FAIL_REGULAR_EXPRESSION "Running 0 tests"
    SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
  if(pocket IN_LIST slow_pockets)
    set_tests_properties(Pocket.${pocket} PROPERTIES LABELS slow)
  endif()
  string(APPEND others ":Pocket/*/${pocket}")
endforeach()
gtest_discover_tests(evenload_tests DISCOVERY_MODE PRE_TEST TEST_FILTER ${others})
gtest_discover_tests(evenload_tests DISCOVERY_MODE PRE_TEST TEST_FILTER Slow* TEST_LIST slow_tests PROPERTIES LABELS slow)
