// SPDX-License-Identifier: LGPL-2.1-or-later
// Reduced membrane between moving tiles: per contact the quadrilateral between the facing pin
// edges, triangulated along both diagonals at half weight each (one alone is biased), and per
// closed polygon round a vertex a fan about one free node. The density is that of the design's
// membranes.
#pragma once

#include "curveups/contact/motion_energy.hpp"
#include "curveups/physics/membrane_energy.hpp"
#include "curveups/physics/membrane_solution.hpp"

namespace curveups {

class ReducedMembrane : public MotionEnergy {
 public:
  // corners: 3 x tiles pin corners as points of their tiles; flat: the same in the layout. Bodies 0
  // to tile_count - 1 are the tiles; nodes follow from first_node on, in the order of the domain's
  // vertex polygons.
  ReducedMembrane(const MembraneDomain& domain, const Points2& flat, const Points3& corners,
                  double tau, const MembraneMaterial& material, int first_node);

  void couple(std::vector<Coupling>& couplings) const override;
  double value(const Poses& poses) const override;
  double derivatives(const Poses& poses, double lever, Motions& gradient,
                     const MotionHessian* hessian) const override;

 private:
  struct Triangle {
    std::array<int, 3> corner;  // element's corners
    Eigen::Matrix2d inverse;    // inverse of the rest edge matrix
    double weight;              // kappa h times the rest area, times its share; N mm
  };
  struct Element {
    std::array<int, 3> body;  // -1: none
    int corner_count;
    std::array<int, 4> slot;    // index into `body` of each corner
    std::array<Vec3, 4> point;  // corner in that body's coordinates
    std::vector<Triangle> triangles;
  };
  void add_triangle(Element& element, const std::array<int, 3>& corner,
                    const std::array<Vec2, 3>& flat, double share) const;
  double evaluate(const Element& element, const Poses& poses, double lever,
                  const MotionHessian* hessian, MotionDerivatives<3>* out) const;

  MembraneMaterial material_;
  double tau_;
  std::vector<Element> elements_;
};

}  // namespace curveups
