// SPDX-License-Identifier: LGPL-2.1-or-later
// Energies of rigid bodies, functions of their poses. Derivatives are by the small motions that
// follow a pose (rigid_body.hpp), so that no parametrization of rotations shows; second ones by
// motions whose origins go straight, which differ from those along screws by terms that vanish
// where forces balance.
#pragma once

#include <memory>

#include "curveups/contact/rigid_body.hpp"
#include "curveups/numerics/block_matrix.hpp"

namespace curveups {

// Second derivatives that an energy adds to.
struct MotionHessian {
  BlockMatrix<6>* matrix;
  int first;       // number of the energy's first coupling in the matrix's pattern
  bool projected;  // positive semi-definite: geometric stiffness is dropped or projected
};

class MotionEnergy {
 public:
  virtual ~MotionEnergy() = default;
  // Appends the pairs of bodies that elements join, for the matrix of second derivatives.
  virtual void couple(std::vector<Coupling>& couplings) const = 0;
  virtual double value(const Poses& poses) const = 0;  // N mm
  // Adds to the gradient (N; of turns: N mm / lever) and, where it is not null, to the second
  // derivatives. Returns the value.
  virtual double derivatives(const Poses& poses, double lever, Motions& gradient,
                             const MotionHessian* hessian) const = 0;
};

// Derivatives of an element of K bodies by their motions, bodies one after another.
template <int K>
struct MotionDerivatives {
  double value = 0;
  Eigen::Matrix<double, 6 * K, 1> gradient = Eigen::Matrix<double, 6 * K, 1>::Zero();
  Eigen::Matrix<double, 6 * K, 6 * K> hessian = Eigen::Matrix<double, 6 * K, 6 * K>::Zero();

  // Sets all to zero; second derivatives, which are large, only where `second`.
  void clear(bool second) {
    value = 0;
    gradient.setZero();
    if (second) hessian.setZero();
  }
  // Adds the rows of these bodies (-1: none, and none after it); coupling: the number of the
  // element's first coupling among the energy's, for pairs (0, 1), (0, 2), (1, 2) and so on.
  void add_to(const std::array<int, K>& body, Motions& sum, const MotionHessian* second,
              int coupling) const {
    for (int k = 0; k < K && body[k] >= 0; ++k) {
      sum.row(body[k]) += gradient.template segment<6>(6 * k).transpose();
    }
    if (!second) return;
    BlockMatrix<6>* matrix = second->matrix;
    coupling += second->first;
    for (int k = 0; k < K; ++k) {
      if (body[k] < 0) break;
      const BlockSlot own = matrix->pattern().diagonal(body[k]);
      if (own.stored()) matrix->add(own, hessian.template block<6, 6>(6 * k, 6 * k));
      for (int l = k + 1; l < K; ++l, ++coupling) {
        const BlockSlot& slot = matrix->pattern().slot(coupling);
        if (!slot.stored()) continue;
        if (slot.swapped) {
          matrix->add(slot, hessian.template block<6, 6>(6 * l, 6 * k));
        } else {
          matrix->add(slot, hessian.template block<6, 6>(6 * k, 6 * l));
        }
      }
    }
  }
};

// Derivatives of a point R p + t by its body's motions: 3 x 6.
Eigen::Matrix<double, 3, 6> point_jacobian(const RigidMotion& pose, const Vec3& p, double lever);

// Second derivatives, by a body's turn, of force . (R p): 3 x 3. arm: R p.
Eigen::Matrix3d turn_curvature(const Vec3& force, const Vec3& arm, double lever);
// The same without its negative eigenvalues.
Eigen::Matrix3d positive_turn_curvature(const Vec3& force, const Vec3& arm, double lever);

// A point p of body `a` where body `b` sees it: y = R_b^T (R_a p + t_a - t_b).
Vec3 seen_from(const RigidMotion& b, const RigidMotion& a, const Vec3& p);

// Adds a function of that y to the derivatives of a pair of bodies. by_y, by_y_twice: derivatives
// by y (second ones only where `hessian` is not null); a, b: 0 and 1 or 1 and 0, of the pair.
// Forces and torques on the two sum to zero whatever the function.
void add_seen_point(const Poses& poses, const std::array<int, 2>& bodies, int a, int b,
                    const Vec3& p, const Vec3& by_y, const Eigen::Matrix3d& by_y_twice,
                    double lever, const MotionHessian* hessian, MotionDerivatives<2>& out);

}  // namespace curveups
