// SPDX-License-Identifier: LGPL-2.1-or-later
// Kinds of support: the choices of the parameter `support`, and the functions that
// fabrication/supports.hpp declares and lists. To add a kind: a line here and a file that returns
// its SupportKind.
#pragma once

// KIND(function, "name among the choices")
#define CURVEUPS_SUPPORT_KINDS(KIND) \
  KIND(slabs, "soluble")             \
  KIND(bridges, "breakaway")         \
  KIND(no_support, "none")
