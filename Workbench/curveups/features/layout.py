# SPDX-License-Identifier: LGPL-2.1-or-later
"""Defines the Layout object: the layout as lists, which a reopened document draws without the native
module."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from .proxy import OUTPUT, READ_ONLY, PartProxy, add


class LayoutProxy(PartProxy):
    """Behaviour of a Layout."""

    TYPE = "CurveUps::Layout"

    def add_properties(self, obj: Any) -> None:
        super().add_properties(obj)
        add(obj, "App::PropertyFloatList", "Poses", "Layout",
            "Flat corners of the tiles, mm: three times x, y for each.", READ_ONLY | OUTPUT)
        add(obj, "App::PropertyFloatList", "Insets", "Layout",
            "Insets of the pins, mm: three of the front and three of the back for each tile.",
            READ_ONLY | OUTPUT)
        add(obj, "App::PropertyVectorList", "Vertices", "Layout", "The actuated front vertices, mm.",
            READ_ONLY | OUTPUT)
        add(obj, "App::PropertyIntegerList", "Faces", "Layout", "Three vertices for each tile.",
            READ_ONLY | OUTPUT)
        add(obj, "App::PropertyBool", "Converged", "Layout", "Whether the optimiser came to its end.",
            READ_ONLY | OUTPUT)
        add(obj, "App::PropertyInteger", "Iterations", "Layout", "Steps of the optimiser.",
            READ_ONLY | OUTPUT)
        add(obj, "App::PropertyFloat", "Energy", "Layout", "Sum of the layout's energies.",
            READ_ONLY | OUTPUT)


def write_layout(obj: Any, results: Mapping[str, Any], design: Any) -> None:
    """Of a run's results and the design they ended with."""
    import FreeCAD

    obj.Poses = np.ravel(design.T).tolist()
    obj.Insets = np.ravel(design.q).tolist()
    obj.Vertices = [FreeCAD.Vector(*row) for row in design.V.tolist()]
    obj.Faces = np.ravel(design.F).tolist()
    layout = results.get("layout")
    if layout is not None:
        obj.Converged, obj.Iterations = layout.converged, layout.iterations
        obj.Energy = sum(layout.energies.values())
