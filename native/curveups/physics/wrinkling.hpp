// SPDX-License-Identifier: LGPL-2.1-or-later
// Relaxation of an isotropic incompressible membrane: where it would be compressed it wrinkles
// (A. C. Pipkin, "The relaxed energy density for isotropic elastic membranes", IMA J. Appl. Math.
// 36, 1986; D. J. Steigmann, "Tension-field theory", Proc. R. Soc. Lond. A 429, 1990). With l1 >=
// l2:
//   taut      l1 >= 1, l2 >= l1^-1/2    the density itself
//   wrinkled  l1 >= 1, l2 <  l1^-1/2    its uniaxial tension u(l1)
//   slack     l1 < 1                    0
// Once continuously differentiable in F. To this it adds regularization |F|^2, so that slack parts
// have a unique position.
#pragma once

#include "curveups/physics/density.hpp"

namespace curveups {

// u at l1, and its first and second derivative.
struct UniaxialTension {
  double value, slope, curvature;
};

// u as a function of F.
Density wrinkled_density(const Gradient32& F, const PrincipalStretches& l, const UniaxialTension& u,
                         bool second);

// taut(): the density where nothing wrinkles; uniaxial(l1): u. Each is only asked for where it
// counts.
template <class Taut, class Uniaxial>
Density relaxed(const Gradient32& F, double regularization, bool second, Taut taut,
                Uniaxial uniaxial) {
  const PrincipalStretches l = principal_stretches(F);
  Density out;
  switch (l.tension()) {
    case MembraneTension::taut:
      out = taut();
      break;
    case MembraneTension::wrinkled:
      out = wrinkled_density(F, l, uniaxial(l.l1), second);
      break;
    case MembraneTension::slack:
      break;
  }
  out.value += regularization * F.squaredNorm();
  out.gradient.head<3>() += 2 * regularization * F.col(0);
  out.gradient.tail<3>() += 2 * regularization * F.col(1);
  if (second) out.hessian.diagonal().array() += 2 * regularization;
  return out;
}

}  // namespace curveups
