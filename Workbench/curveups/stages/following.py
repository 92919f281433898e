# SPDX-License-Identifier: LGPL-2.1-or-later
"""Carries the tiles, cuts and places of an earlier design along when its target changes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np

from ..base.findings import Finding, Value
from ..base.native import native
from .cut_request import CutRequest, interior_edges
from .stage import Job


@dataclass(frozen=True)
class Earlier(Value):
    """Tiles to be carried along: V (N x 3, mm) and F (M x 3) of a target, cuts (C x 2). layout: T (M x 3 x 2)
    and q (M x 2 x 3), where they have one. scale: their target's. divided: the cuts include borders of
    pieces."""

    V: np.ndarray
    F: np.ndarray
    cuts: np.ndarray
    layout: Optional[tuple[np.ndarray, np.ndarray]]
    scale: float
    divided: bool = False

    @classmethod
    def of(cls, design: Any) -> "Earlier":
        """Tiles of a native Design, before vertices moved for pins and forces."""
        V, F = design.target or (design.V, design.F)
        return cls(V, F, design.cuts, (design.T, design.q), design.parameters.get("scale"),
                   design.parameters.get("pieces") != "1")


@dataclass(frozen=True)
class Following(Value):
    """Outcome. V: vertices of the earlier tiles at the present scale. said: how the tiling came. mesh: native
    FollowedMesh; None where the target is tiled anew. cuts: the earlier ones, of the new tiles. lost: number
    of cuts that could not be carried along."""

    earlier: Earlier
    V: np.ndarray
    said: Finding
    mesh: Optional[Any] = None
    cuts: Optional[np.ndarray] = None
    lost: int = 0

    def warnings(self) -> tuple[Finding, ...]:
        """Warnings of what did not go along."""
        if self.mesh is None:
            return (self.said,)
        return (Finding.about("followed.cuts", count=self.lost),) if self.lost else ()

    @property
    def start(self) -> Optional[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """T and q of the earlier layout, and for each new tile its row of them, or -1."""
        if self.mesh is None or self.earlier.layout is None:
            return None
        return (*self.earlier.layout, self.mesh.tile_from)


def follow(earlier: Earlier, V: np.ndarray, F: np.ndarray, parameters: Any, creases: Optional[np.ndarray],
           job: Job) -> Following:
    """Follow a clean mesh (V, F). creases: as in target.remesh."""
    scaled = earlier.V * (parameters.get("scale") / earlier.scale)
    mesh = native.follow_mesh(scaled, earlier.F, V, F, parameters.get("L"), parameters.get("crease_angle"),
                              creases, job)
    if mesh.obstacle:
        return Following(earlier, scaled, Finding.about("tiled_anew", why=Finding(f"follow.{mesh.obstacle}")))
    kept = int((mesh.tile_from >= 0).sum())
    cuts, lost = _carried(earlier.cuts, mesh)
    said = Finding.about("followed", kept=kept, new=len(mesh.F) - kept)
    return Following(earlier, scaled, said, mesh, cuts, lost)


def carried_cuts(outcome: Following, where: str) -> CutRequest:
    """Request for the earlier design's cuts: by coordinates where the target is tiled anew."""
    earlier = outcome.earlier
    if outcome.cuts is None:
        return CutRequest(polylines=tuple(outcome.V[edge] for edge in earlier.cuts), where=where)
    return CutRequest(outcome.cuts, where=where, divided=earlier.divided)


def _carried(cuts: np.ndarray, mesh: Any) -> tuple[np.ndarray, int]:
    """Cuts of the new tiles (C x 2), and the number of those that could not be carried along. Where an edge
    is gone, the shortest way along edges joins its ends."""
    place = {int(old): new for new, old in enumerate(mesh.vertex_from) if old >= 0}
    edges = interior_edges(mesh.F)
    kept: set[tuple[int, int]] = set()
    gone: list[tuple[int, int]] = []
    for a, b in cuts.tolist():
        ends = place.get(a, -1), place.get(b, -1)
        pair = min(ends), max(ends)
        if pair in edges:
            kept.add(pair)
        else:
            gone.append((a, b))
    lost = 0
    for stretch in _stretches(gone):
        left = [place[v] for v in stretch if v in place]
        for a, b in zip(left, left[1:]):
            path = native.shortest_edge_path(mesh.V, mesh.F, mesh.V[[a, b]])
            kept.update((min(pair), max(pair)) for pair in zip(path, path[1:]))
        lost += len(stretch) - 1 if len(left) < 2 else 0
    return np.array(sorted(kept & edges), np.int32).reshape(-1, 2), lost


def _stretches(edges: list[tuple[int, int]]) -> list[list[int]]:
    """Vertices of lines of edges, along each line."""
    around: dict[int, list[int]] = {}
    for a, b in edges:
        around.setdefault(a, []).append(b)
        around.setdefault(b, []).append(a)
    lines = []
    left = {frozenset(edge) for edge in edges}
    for start in sorted(around, key=lambda v: (len(around[v]) == 2, v)):  # ends first
        for first in around[start]:
            line: list[int] = [start]
            following: Optional[int] = first
            while following is not None and frozenset((line[-1], following)) in left:
                left.discard(frozenset((line[-1], following)))
                line.append(following)
                ways = [v for v in around[following] if frozenset((following, v)) in left]
                following = ways[0] if len(around[line[-1]]) == 2 and ways else None
            if len(line) > 1:
                lines.append(line)
    return lines
