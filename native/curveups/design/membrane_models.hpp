// SPDX-License-Identifier: LGPL-2.1-or-later
// Energy densities of membranes: the choices of the parameter membrane_model, and the functions
// that physics/density.hpp declares and lists. To add a density: a line here and a file
// physics/FUNCTION.cpp.
#pragma once

// MODEL(function, "name among the choices")
#define CURVEUPS_MEMBRANE_MODELS(MODEL) \
  MODEL(tension_field, "tension-field") \
  MODEL(neo_hookean, "neo-hookean")
