// SPDX-License-Identifier: LGPL-2.1-or-later
// Exceptions of this library, each a Python exception of the same name, for impossible input and
// topology. Not converging is an outcome that results report.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace curveups {

// Message in one sentence that names the offending input, remedy, and tiles concerned (rows of F).
class Error : public std::runtime_error {
 public:
  Error(const std::string& what, std::string remedy, std::vector<int> tiles = {})
      : std::runtime_error(what), remedy_(std::move(remedy)), tiles_(std::move(tiles)) {}
  const std::string& remedy() const { return remedy_; }
  const std::vector<int>& tiles() const { return tiles_; }

 private:
  std::string remedy_;
  std::vector<int> tiles_;
};

// A value, file or array that is not what the contract asks for.
class InvalidInput : public Error {
  using Error::Error;
};
// A surface that is not an oriented manifold with boundary.
class TopologyError : public Error {
  using Error::Error;
};
// Sound input for which no tiles, pins or solids with these parameters exist.
class InfeasibleDesign : public Error {
  using Error::Error;
};
// A numerical method broke down (not: stopped early).
class SolverFailure : public Error {
  using Error::Error;
};
// A file could not be read or written.
class IoError : public Error {
  using Error::Error;
};
// Thrown by work that has no partial result when the progress sink asked to stop.
class Cancelled : public Error {
 public:
  Cancelled() : Error("stopped", "") {}
};

}  // namespace curveups
