# SPDX-License-Identifier: LGPL-2.1-or-later
"""How hands release a piece from the rings of its sheets, by the names that the native module knows."""

CUT = "cut"  # out of both sheets while they are on their rings; the others keep surplus and anchors at first
RELEASES = (CUT, "together", "front-first", "back-first")
