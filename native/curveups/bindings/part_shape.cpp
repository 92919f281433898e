// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/bindings.hpp"

#ifdef __linux__
#include <dlfcn.h>
#endif

#include <string>

#include "curveups/fabrication/print_solids.hpp"

namespace curveups::bindings {
namespace {

// Part::shape2pyshape(const TopoDS_Shape&). It returns a PyCXX object, which is not trivial and so
// comes back through a hidden pointer: a table of virtual functions and the Python object, whose
// one reference becomes ours.
struct ReturnedObject {
  void* table = nullptr;
  PyObject* object = nullptr;
};
using Convert = void* (*)(ReturnedObject*, const TopoDS_Shape&);

Convert find_conversion(const py::module_& part) {
#ifdef __linux__  // elsewhere such an object may come back in another way
  const std::string library = part.attr("__file__").cast<std::string>();
  void* handle = ::dlopen(library.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (!handle) return nullptr;
  void* symbol = ::dlsym(handle, "_ZN4Part13shape2pyshapeERK12TopoDS_Shape");
  ::dlclose(handle);  // NOLOAD counted it up; whoever loaded it keeps it
  return reinterpret_cast<Convert>(symbol);
#else
  return nullptr;
#endif
}

}  // namespace

py::object to_part_shape(const TopoDS_Shape& shape) {
  py::module_::import("FreeCAD");
  const py::module_ part = py::module_::import("Part");
  if (const Convert convert = find_conversion(part)) {
    ReturnedObject returned;
    convert(&returned, shape);
    if (returned.object) return py::reinterpret_steal<py::object>(returned.object);
    PyErr_Clear();
  }
  const py::object folder = py::module_::import("tempfile").attr("TemporaryDirectory")();
  const std::string path = folder.attr("name").cast<std::string>() + "/shape.bin";
  write_binary_brep(shape, path);
  py::object out = part.attr("Shape")();
  out.attr("importBinary")(path);
  folder.attr("cleanup")();
  return out;
}

}  // namespace curveups::bindings
