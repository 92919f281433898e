# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of a design: what is measured and checked of them, and what the printer makes of it."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Sequence

from .progress import Progress

PRINTERS = Path(__file__).parents[2] / "resources" / "printers"


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


def measure(model: Any, parameters: Any, progress: Progress) -> SolidFigures:
    """Checks every solid (BRepCheck, closed, volume) and measures clearances and overlaps."""
    unsound = [f"{body}: {reason}" for body, reason in model.check_solids(progress)]
    figures = SolidFigures(
        tiles=int(model.tile_count), bodies=int(model.body_count),
        pieces=int(model.piece_count), bbox_mm=tuple(float(x) for x in model.bbox),
        tile_volume_mm3=model.volumes["tiles"], support_volume_mm3=model.volumes["support"],
        anchor_volume_mm3=model.volumes["anchors"],
        smallest_feature_mm=min((size for _, _, size in model.thinnest), default=0.0),
        min_clearance_flat_mm=model.min_clearance_flat(),
        max_overlap_actuated_mm3=model.max_overlap_actuated(), unsound=unsound)
    figures.warnings = model_warnings(model) + _printer_warnings(model, figures, parameters)
    return figures


def model_warnings(model: Any) -> list[dict]:
    """What the bodies lack, though they can be built."""
    warnings = []
    bare = list(model.bare_interfaces)
    if bare:
        tiles = sorted({tile for a, b, _ in bare for tile in (a, b)})
        warnings.append({"what": f"{len(bare)} interfaces carry no bumps: {bare[0][2]}",
                         "kind": "bare_interface", "tiles": tiles})
    loose = [int(tile) for tile in model.loose_tiles]
    if loose:
        warnings.append({"what": f"{len(loose)} tiles are not held by the support",
                         "kind": "loose", "tiles": loose})
    if model.loose_anchors:
        warnings.append({"what": f"{model.loose_anchors} anchors are not held by the support",
                         "kind": "loose", "tiles": []})
    return warnings


def _printer_warnings(model: Any, figures: SolidFigures, parameters: Any) -> list[dict]:
    """What the chosen printer can't make: bed, gaps, features."""
    printer = read_printer(parameters.get("printer"))
    warnings = []
    box = figures.bbox_mm
    if not fits_bed(box, printer):
        warnings.append({"what": f"the print ({box[0]:.0f} x {box[1]:.0f} x {box[2]:.0f} mm) is larger "
                                 f"than the bed of a {printer['name']}",
                         "kind": "bed", "tiles": []})
    if figures.min_clearance_flat_mm < printer["smallest_gap_mm"]:
        warnings.append({"what": f"tiles come as near as {figures.min_clearance_flat_mm:.3g} mm; a "
                                 f"{printer['name']} needs {printer['smallest_gap_mm']:g} mm",
                         "kind": "gap", "tiles": []})
    thin = [row for row in model.thinnest if row[2] < printer["smallest_feature_mm"]]
    if thin:
        body, what, size = min(thin, key=lambda row: row[2])
        tiles = sorted(int(row[0][1:]) - 1 for row in thin
                       if row[0][:1] == "T" and row[0][1:].isdigit())
        warnings.append({"what": f"{len(thin)} bodies have features smaller than a {printer['name']} "
                                 f"makes; {body}: {what}, {size:.3g} mm",
                         "kind": "feature", "tiles": tiles})
    return warnings


def read_printer(name: str) -> dict:
    """What is known of a printer: bed, resolution, smallest gap and feature, sources."""
    return json.loads((PRINTERS / f"{name}.json").read_text(encoding="utf-8"))


def fits_bed(box: Sequence[float], printer: dict) -> bool:
    """Whether a print of this size fits, turned by a right angle where that helps."""
    bed = printer["bed_mm"]
    return (box[2] <= bed[2] and min(box[:2]) <= min(bed[:2]) and max(box[:2]) <= max(bed[:2]))
