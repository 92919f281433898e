// SPDX-License-Identifier: LGPL-2.1-or-later
// STL, 3MF and STEP of bodies; the same bodies give the same bytes.
#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "curveups/fabrication/body_mesh.hpp"

namespace curveups {

// A file that is removed where it is not closed.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(const std::string& bytes);
  // Throws IoError, naming the path and the system's reason, where any step failed.
  void close();

 private:
  void note_failure();

  std::string path_;
  std::ofstream file_;
  int failure_ = 0;  // errno of the first step that failed
  bool opened_, complete_ = false;
};

// Throws what OutputFile::close throws.
void write_bytes(const std::string& path, const std::string& bytes);

// Appends a whole number of `size` bytes, the lowest byte first.
inline void append_number(std::string& bytes, std::uint64_t value, int size) {
  for (int k = 0; k < size; ++k) bytes.push_back(static_cast<char>(value >> 8 * k));
}

// Appends the shortest digits that read back the same. Throws SolverFailure for a number that is
// not finite.
void append_real(std::string& text, double value);

// Writes a binary STL of all bodies; the header names the title and the unit. Throws IoError.
void write_stl(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::string& path);

// Writes 3MF in mm. Each piece is one build item, an assembly whose components are one
// named object with its material per body: slicers place build items anew, and components keep
// their places. materials: names by BodyKind; a slicer's user gives each its own filament or
// nozzle. Throws IoError, Cancelled, SolverFailure for a coordinate that is not finite.
void write_3mf(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::array<std::string, 3>& materials, const std::string& path);

// Writes an AP214 assembly of all bodies in mm, each a named, coloured product. Names of bodies
// differ. Products' ids are unique among the files of a design: `title`, and "title/name" for
// parts. Written without OpenCASCADE, whose writer takes 16 s and 0.8 GB for 2500 tiles and rounds
// coordinates. Throws IoError, Cancelled, SolverFailure for a coordinate that is not finite.
void write_step(const std::vector<const PrintBody*>& bodies, const std::string& title,
                const std::string& path);

}  // namespace curveups
