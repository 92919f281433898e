// SPDX-License-Identifier: LGPL-2.1-or-later
// The energy densities of membranes: the choices of the parameter membrane_model, and what
// physics/density.hpp declares and lists. Here and in its own file physics/FUNCTION.cpp a density
// is all there is of it.
#pragma once

// MODEL(function, "name among the choices", whether its Hessian is nowhere indefinite)
#define CURVEUPS_MEMBRANE_MODELS(MODEL)        \
  MODEL(tension_field, "tension-field", true)  \
  MODEL(mooney_rivlin, "mooney-rivlin", false) \
  MODEL(neo_hookean, "neo-hookean", false)
