// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/path_memory.hpp"

#include <cmath>
#include <limits>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

constexpr double largest_place = 1e8;  // mm
constexpr double any = std::numeric_limits<double>::infinity();

[[noreturn]] void refuse() {
  throw InvalidInput("the frame's memory is not of this design",
                     "give a frame of this design, or take its memory out");
}

// Goes over all numbers of a state, in one order. `Numbers` writes or reads them.
template <class Numbers>
void visit(Numbers& all, ContactWorld::PathState& path) {
  all.scalar(path.state.weight, -any, any);
  all.scalar(path.convex, 0, 1);
  all.count(path.state.poses);
  for (RigidMotion& pose : path.state.poses) {
    all.entries(pose.R, -2, 2);
    all.entries(pose.t, -largest_place, largest_place);
  }
  int rows = static_cast<int>(path.places.rows());
  all.integer(rows);
  path.places.conservativeResize(all.checked(rows), 3);
  all.entries(path.places, -largest_place, largest_place);
  all.count(path.coupled);
  for (auto& pair : path.coupled) {
    for (int& body : pair) all.integer(body);
  }
  all.count(path.state.pairs);
  for (TouchingPair& pair : path.state.pairs) {
    for (int& body : pair.body) all.integer(body);
    for (int& face : pair.face) all.integer(face);
    for (int& face : pair.earlier) {
      int number = face + 1;  // -1: none
      all.integer(number);
      face = number - 1;
    }
    all.integer(pair.turns);
    all.count(pair.touches);
    for (Touch& touch : pair.touches) {
      all.integer(touch.of);
      for (Vec3* vector : {&touch.point, &touch.normal}) {
        all.entries(*vector, -largest_place, largest_place);
      }
      all.scalar(touch.offset, -largest_place, largest_place);
      all.entries(touch.tangents, -2, 2);
      all.scalar(touch.stiffness, 1e-12, 1e12);
      all.scalar(touch.tangent_stiffness, 1e-12, 1e12);
      for (Vec2* vector : {&touch.stretch, &touch.reference}) {
        all.entries(*vector, -largest_place, largest_place);
      }
      all.entries(touch.built, -any, any);
      all.scalar(touch.cap, 0, any);
      all.scalar(touch.slip, 0, any);
    }
  }
}

struct Writer {
  std::vector<double> out;

  void scalar(double& value, double, double) { out.push_back(value); }
  void integer(int& value) { out.push_back(value); }
  int checked(int rows) const { return rows; }
  template <class List>
  void count(List& list) {
    out.push_back(static_cast<double>(list.size()));
  }
  template <class Matrix>
  void entries(Matrix& matrix, double, double) {
    out.insert(out.end(), matrix.data(), matrix.data() + matrix.size());
  }
};

struct Reader {
  const Eigen::VectorXd& in;
  Eigen::Index at = 0;

  double next() {
    if (at >= in.size()) refuse();
    return in(at++);
  }
  void scalar(double& value, double least, double most) {
    value = next();
    if (!(value >= least && value <= most)) refuse();
  }
  void integer(int& value) {
    const double number = next();
    if (!(number >= 0 && number <= 1e9) || number != std::floor(number)) refuse();
    value = static_cast<int>(number);
  }
  // No more than there are numbers left.
  int checked(int rows) const {
    if (rows > in.size() - at) refuse();
    return rows;
  }
  template <class List>
  void count(List& list) {
    int size = 0;
    integer(size);
    list.resize(checked(size));
  }
  template <class Matrix>
  void entries(Matrix& matrix, double least, double most) {
    for (Eigen::Index k = 0; k < matrix.size(); ++k) scalar(matrix.data()[k], least, most);
  }
};

// Pairs of bodies of the world that can touch, in ascending order.
template <class Pairs, class Get>
void check_pairs(const Pairs& pairs, const std::vector<RigidBody>& bodies, const Get& get) {
  const int count = static_cast<int>(bodies.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const std::array<int, 2> pair = get(pairs[k]);
    if (pair[0] >= pair[1] || pair[1] >= count || (k > 0 && !(get(pairs[k - 1]) < pair)) ||
        !bodies[pair[0]].can_touch(bodies[pair[1]])) {
      refuse();
    }
  }
}

}  // namespace

Eigen::VectorXd packed(ContactWorld::PathState state) {
  std::size_t touches = 0;
  for (const TouchingPair& pair : state.state.pairs) touches += pair.touches.size();
  Writer all;
  all.out.reserve(32 * (touches + state.state.pairs.size() + state.state.poses.size()));
  all.out.push_back(memory_format);
  visit(all, state);
  return Eigen::Map<const Eigen::VectorXd>(all.out.data(),
                                           static_cast<Eigen::Index>(all.out.size()));
}

ContactWorld::PathState unpacked(const Eigen::VectorXd& numbers, const ContactWorld& world) {
  const std::vector<RigidBody>& bodies = world.bodies();
  Reader all{numbers};
  if (all.next() != memory_format) refuse();
  ContactWorld::PathState path;
  visit(all, path);
  const std::size_t count = bodies.size();
  if (all.at != numbers.size() || path.state.poses.size() != count ||
      (path.places.rows() > 0 && path.places.rows() != static_cast<Eigen::Index>(count)) ||
      std::isinf(path.state.weight)) {
    refuse();
  }
  for (const RigidMotion& pose : path.state.poses) {
    if (!(pose.R * pose.R.transpose()).isIdentity(1e-6) || pose.R.determinant() < 0) refuse();
  }
  check_pairs(path.coupled, bodies, [](const std::array<int, 2>& pair) { return pair; });
  check_pairs(path.state.pairs, bodies, [](const TouchingPair& pair) { return pair.body; });
  for (const TouchingPair& pair : path.state.pairs) {
    for (int k = 0; k < 2; ++k) {
      if (pair.face[k] >= static_cast<int>(bodies[pair.body[k]].faces.size())) refuse();
    }
    for (const Touch& touch : pair.touches) {
      if (touch.of > 1) refuse();
    }
  }
  return path;
}

}  // namespace curveups
