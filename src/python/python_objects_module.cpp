#include "python/python_objects_module.h"

namespace py = pybind11;

namespace evenload {
namespace {

// Asks nothing of the objects but their type: others' may run code when asked for more.
py::list objects_of_type(const py::type& kind) {
  auto* const type = reinterpret_cast<PyTypeObject*>(kind.ptr());
  const py::object get_objects = py::module_::import("gc").attr("get_objects");
  py::list found;
  const py::list all = get_objects();
  for (const py::handle object : all)
    if (PyType_IsSubtype(Py_TYPE(object.ptr()), type)) found.append(object);
  return found;
}

}  // namespace

void bind_python_objects(py::module_& module) {
  module.def("objects_of_type", &objects_of_type, py::arg("kind"),
             "The objects that Python's collector of garbage knows and whose type is `kind` or "
             "derived from it.\n\n"
             "As gc.get_objects(), but no other thread runs while it has hold of the rest of them. "
             "Among these may be a tuple that a thread is just making from a generator, and which "
             "it cannot finish, with SystemError, while anybody else holds it.");
}

}  // namespace evenload
