// SPDX-License-Identifier: LGPL-2.1-or-later
// OpenCASCADE's exceptions are no std::exception: nothing outside this room would know them.
#pragma once

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <new>
#include <string>

#include "curveups/core/errors.hpp"

namespace curveups {

// work(), of which `what` says what is done to which body. Throws SolverFailure where OpenCASCADE
// throws, std::bad_alloc for want of memory.
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

}  // namespace curveups
