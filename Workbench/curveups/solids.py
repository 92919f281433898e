# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of a design: what is built, measured and checked of them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from .errors import tile_name
from .native import native
from .progress import Progress


@dataclass
class SolidFigures:
    """Figures of the print, for reports and the verdict. Lengths in mm, volumes in mm3."""

    tiles: int
    bodies: int
    pieces: int
    bbox_mm: tuple[float, float, float]
    tile_volume_mm3: float
    support_volume_mm3: float
    anchor_volume_mm3: float
    smallest_feature_mm: float
    min_clearance_flat_mm: float
    max_overlap_actuated_mm3: float
    unsound: list[str] = field(default_factory=list)   # bodies with the reason
    warnings: list[dict] = field(default_factory=list)


def measure(model: Any, progress: Progress) -> SolidFigures:
    """Checks every solid (BRepCheck, closed, volume) and measures clearances and overlaps."""
    unsound = [f"{body}: {reason}" for body, reason in model.check_solids(progress)]
    volumes = model.volumes
    return SolidFigures(
        tiles=int(model.tile_count), bodies=int(model.body_count), pieces=int(model.piece_count),
        bbox_mm=tuple(float(x) for x in model.bbox),
        tile_volume_mm3=volumes["tiles"], support_volume_mm3=volumes["support"],
        anchor_volume_mm3=volumes["anchors"],
        smallest_feature_mm=min((size for _, _, size in model.thinnest), default=0.0),
        min_clearance_flat_mm=model.min_clearance_flat(),
        max_overlap_actuated_mm3=model.max_overlap_actuated(),
        unsound=unsound)
