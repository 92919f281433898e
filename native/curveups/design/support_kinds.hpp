// SPDX-License-Identifier: LGPL-2.1-or-later
// The kinds of support: the choices of the parameter `support`, and what fabrication/supports.hpp
// declares and lists. Here and in the file of its function, which gives all of it (SupportKind), a
// kind is all there is of it.
#pragma once

// KIND(function, "name among the choices")
#define CURVEUPS_SUPPORT_KINDS(KIND) \
  KIND(slabs, "soluble")             \
  KIND(bridges, "breakaway")         \
  KIND(no_support, "none")
