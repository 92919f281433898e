# SPDX-License-Identifier: LGPL-2.1-or-later
"""Readers of target files: meshes, CAD parts and what of a part is the surface. Without a window."""
