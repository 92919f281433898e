// SPDX-License-Identifier: LGPL-2.1-or-later
// OpenCASCADE solids of bodies, built face by face with shared edges: no sewing, no booleans.
#pragma once

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TopoDS_Shape.hxx>
#include <new>
#include <string>
#include <vector>

#include "curveups/bodies/print_body.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {

// Calls work() and turns OpenCASCADE's exceptions, which are no std::exception, into SolverFailure
// or std::bad_alloc. what: the action and its body, for the message.
template <class Work>
auto with_occ_errors(const std::string& what, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& failure) {
    const char* said = failure.GetMessageString();
    const bool silent = said == nullptr || *said == '\0';
    throw SolverFailure(
        "OpenCASCADE failed " + what + " (" + (silent ? failure.DynamicType()->Name() : said) + ")",
        "report this with the design file");
  }
}

// Makes a solid of one closed shell, with true spheres and cylinders for caps and cylinders. Throws
// SolverFailure where OpenCASCADE fails.
TopoDS_Shape make_solid(const PrintBody& body);

// Makes the solids of all bodies in parallel. Throws Cancelled, SolverFailure.
std::vector<TopoDS_Shape> make_solids(const std::vector<const PrintBody*>& bodies);

TopoDS_Shape make_compound(const std::vector<TopoDS_Shape>& shapes);

}  // namespace curveups
