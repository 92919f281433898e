# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads target files: meshes, CAD parts, and the surface of a part. It needs no window."""
