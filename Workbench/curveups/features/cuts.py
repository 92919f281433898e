# SPDX-License-Identifier: LGPL-2.1-or-later
"""Defines the Cuts object: the cuts that the user asked for. Solve makes a layout with them."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..base.errors import CurveUpsError
from ..stages.cut_request import CutRequest
from .proxy import PartProxy, add, refresh, write


class CutsProxy(PartProxy):
    """Behaviour of Cuts. Edges are pairs of the Target's vertices; points keep where they are on the
    surface, for a target that is divided anew."""

    TYPE = "CurveUps::Cuts"

    def add_properties(self, obj: Any) -> None:
        super().add_properties(obj)
        add(obj, "App::PropertyIntegerList", "Edges", "Cuts",
            "Pairs of the Target's vertices: edges across which tiles are disconnected. Takes effect with "
            "Solve.")
        add(obj, "App::PropertyVectorList", "Points", "Cuts",
            "Where the edges are, mm: polylines one after another.")
        add(obj, "App::PropertyIntegerList", "PointCounts", "Cuts", "How many points each polyline has.")

    def onChanged(self, obj: Any, name: str) -> None:
        if self.ready and name == "Edges":
            refresh(obj)


def write_cuts(obj: Any, edges: np.ndarray, V: np.ndarray) -> None:
    """edges: C x 2 vertices of V (N x 3, mm)."""
    import FreeCAD

    edges = np.asarray(edges, int).reshape(-1, 2)
    write(obj, "Points", [FreeCAD.Vector(*map(float, V[v])) for edge in edges for v in edge])
    write(obj, "PointCounts", [2] * len(edges))
    write(obj, "Edges", [int(v) for v in edges.ravel()])


def edges_of(obj: Any) -> np.ndarray:
    """C x 2. Raises CurveUpsError where the list is none of pairs."""
    if len(obj.Edges) % 2:
        raise CurveUpsError("the list of cuts has an odd number of vertices", obj.Label,
                            "remove one from its Edges")
    return np.array(obj.Edges, np.int32).reshape(-1, 2)


def request_of(obj: Any, by_number: bool) -> CutRequest:
    """What the project is asked for; by places where the target is to be divided anew."""
    if obj is None or not obj.Edges:
        return CutRequest()
    if by_number or not obj.Points:
        return CutRequest(edges=edges_of(obj), where=obj.Label)
    points, lines = [tuple(point) for point in obj.Points], []
    for count in obj.PointCounts:
        lines.append(np.array(points[:count], float).reshape(-1, 3))
        del points[:count]
    return CutRequest(polylines=tuple(lines), where=obj.Label)
