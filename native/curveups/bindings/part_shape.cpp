// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/part_shape.hpp"

#include <dlfcn.h>

#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <TopoDS_Shape.hxx>
#include <fstream>
#include <string>

#include "curveups/core/errors.hpp"

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
  const std::string file = part.attr("__file__").cast<std::string>();
  void* library = dlopen(file.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (!library) return nullptr;
  void* symbol = dlsym(library, "_ZN4Part13shape2pyshapeERK12TopoDS_Shape");
  dlclose(library);  // NOLOAD counted it up; Python keeps it loaded
  return reinterpret_cast<Convert>(symbol);
}

// What Part.Shape.importBinary reads: the shape set, then which of its shapes, where and how.
void write_binary(TopoDS_Shape shape, const std::string& path) {
  BinTools_ShapeSet set;
  const int number = set.Add(shape), place = set.Locations().Index(shape.Location()),
            orientation = static_cast<int>(shape.Orientation());
  std::ofstream out(path, std::ios::binary);
  set.Write(out);
  BinTools::PutInteger(out, number);
  BinTools::PutInteger(out, place);
  BinTools::PutInteger(out, orientation);
  out.close();
  if (!out) throw IoError("a temporary file can't be written (" + path + ")", "free some space");
}

}  // namespace

py::object to_part_shape(const TopoDS_Shape& shape, bool direct) {
  py::module_::import("FreeCAD");
  const py::module_ part = py::module_::import("Part");
  if (const Convert convert = direct ? find_conversion(part) : nullptr) {
    ReturnedObject returned;
    convert(&returned, shape);
    if (returned.object) return py::reinterpret_steal<py::object>(returned.object);
    PyErr_Clear();
  }
  const py::object folder = py::module_::import("tempfile").attr("TemporaryDirectory")();
  const std::string path = folder.attr("name").cast<std::string>() + "/shape.bin";
  write_binary(shape, path);
  py::object out = part.attr("Shape")();
  out.attr("importBinary")(path);
  folder.attr("cleanup")();
  return out;
}

}  // namespace curveups::bindings
