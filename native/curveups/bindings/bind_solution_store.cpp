// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/bindings.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups::bindings {

void bind_solution_store(py::module_& module) {
  py::class_<SolutionStore>(module, "SolutionStore",
                            "Membranes and forces of one design at most, for whoever solves it "
                            "next. Served once, and only to the very design they belong to.")
      .def(py::init<>())
      .def("clear", &SolutionStore::clear, "Gives their memory back.");
}

}  // namespace curveups::bindings
