# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces over the plane, and projects of surfaces."""

import numpy as np
from curveups.base.native import native
from curveups.base.parameters import with_values
from curveups.project.project import Project
from curveups.stages.cut_request import CutRequest
from curveups.stages.surface import Source
from curveups.targets.cad_files import Read


def sheet(height, size=30.0, parts=30):
    """V and F of a square sheet at height(x, y), from -size to size."""
    steps = np.linspace(-size, size, parts + 1)
    V = np.array([(x, y, height(x, y)) for y in steps for x in steps])
    a = np.array([j * (parts + 1) + i for j in range(parts) for i in range(parts)])
    F = np.stack([a, a + 1, a + parts + 2, a, a + parts + 2, a + parts + 1], 1).reshape(-1, 3)
    return V, F.astype(np.int32)


def tent(height=8.0, width=12.0, parts=48):
    """A ridge between two tips, 16 mm long, inside of a plate of 48 mm."""
    return sheet(lambda x, y: height * max(0.0, 1 - np.hypot(max(abs(x) - 8, 0.0), y) / width), 24, parts)


def project(V, F, cuts=CutRequest(), remesh=True, will_be_cut=True, **values):
    """A surface with these parameters."""
    source = Source("made", stamp="made", remesh=remesh, will_be_cut=will_be_cut,
                    read=lambda *_: Read(V, F))
    return Project("made", with_values(native.Parameters(), values),
                   {"source": source, "cut request": cuts}, "made")
