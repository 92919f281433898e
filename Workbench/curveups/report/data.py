# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.json: the format that print shops and scripts read. Blocks of stages not run are absent."""

from __future__ import annotations

import json
import math
import resource
from typing import Any

import numpy as np

from .. import __version__, suggestions
from ..native import native
from ..verdict import small_pins, warn_unsettled

FORMAT, VERSION = "curveups-report", 1


def build_report(outcome: Any, files: dict[str, int], software: dict[str, str]) -> dict:
    """The report on an outcome; `files`: what has been written so far, with sizes in bytes."""
    figures, design = outcome.figures, outcome.design
    report = {
        "format": FORMAT, "version": VERSION, "name": outcome.name,
        "status": "stopped" if outcome.stopped else "complete",
        "tiles": int(len(design.F)), "contacts": int(figures.contacts),
        "cuts": int(len(design.cuts)),
        "valid": outcome.verdict.valid, "reasons": outcome.verdict.reasons,
        "warnings": (outcome.warnings + warn_unsettled(outcome) + _pin_warnings(outcome)
                     + _hinge_warnings(outcome)),
        "front": "the side that the normals of F point to; counter-clockwise seen from there",
        "area": {
            "actuated_cm2": figures.actuated_area_mm2 / 100,
            "flat_cm2": figures.flat_area_mm2 / 100,
            "ratio": figures.flat_area_mm2 / figures.actuated_area_mm2,
        },
        "constraints": _constraints(figures),
        "truncation": {"pairs_of_type": [int(n) for n in figures.truncation_types],
                       "three_point_contacts": int(figures.three_point_contacts),
                       "hinges": len(figures.hinges)},
    }
    if outcome.target is not None:
        report["target"] = _target(outcome.target)
        report["deviation"] = _deviation(outcome)
    if outcome.layout is not None:
        report["layout"] = _layout(outcome.layout)
        if outcome.stretch is not None:
            report["layout"]["stretch"] = outcome.stretch
    if outcome.suggestions:
        report["suggested_cuts"] = suggestions.to_list(outcome.suggestions)
    if outcome.verification is not None:
        blocks = outcome.verification.to_dict()
        report.update({key: blocks[key] for key in ("physics", "contact_forces", "unilateral")
                       if key in blocks})
        report["warnings"] += blocks.get("warnings", [])
    if outcome.recheck is not None:
        blocks = outcome.recheck.to_dict()
        report["recheck"] = {key: blocks[key] for key in
                             ("valid", "reasons", "physics", "contact_forces", "unilateral")
                             if key in blocks}
    if outcome.relief is not None:
        report["relief"] = _relief(outcome.relief)
    if outcome.repair is not None:
        report["repair"] = _repair(outcome.repair)
    if outcome.solids is not None:
        report["warnings"] += outcome.solids.warnings
        report["solids"] = _solids(outcome)
        report["print"] = _print(outcome, files)
    report["stages"] = [{"name": stage.name, "seconds": round(stage.seconds, 3),
                         "iterations": int(stage.iterations)} for stage in outcome.stages]
    report["peak_memory_mb"] = round(
        resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024, 1)
    report["software"] = {"curveups": __version__, **software}
    return report


def to_text(report: dict) -> str:
    """JSON without numbers that are no numbers."""
    return json.dumps(_finite(report), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(item) for item in value]
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def _constraints(figures: Any) -> dict:
    constraints = figures.constraints
    return {
        "max_rigidity_mm": constraints.max_rigidity_mm,
        "max_gap_violation_mm": constraints.max_gap_violation_mm,
        "max_pin_bound_violation_mm": constraints.max_pin_bound_violation_mm,
        "max_pin_area_violation_mm2": constraints.max_pin_area_violation_mm2,
        "pin_sides_below_area": len(constraints.small_pins),
        "overlaps": len(constraints.close_pairs),
    }


def _target(target: Any) -> dict:
    return {"mean_edge_mm": target.mean_edge, "edge_cv": target.edge_cv,
            "sagitta_mm": target.sagitta, "notes": target.notes}


def _deviation(outcome: Any) -> dict:
    target, design = outcome.target, outcome.design
    mean, largest, hausdorff = native.surface_deviation(design.V, design.F, target.source_V,
                                                        target.source_F)
    return {"mean_mm": mean, "max_mm": largest, "hausdorff_mm": hausdorff}


def _relief(relief: Any) -> dict:
    return {"largest_move_mm": relief.largest_move_mm,
            "pin_sides": [{"tile": int(pin.tile), "side": pin.side, "area_before_mm2": pin.area}
                          for pin in relief.relieved],
            "remaining": len(relief.remaining)}


def _repair(repair: Any) -> dict:
    return {"status": repair.status, "restored_mm": repair.restored_mm,
            "largest_move_mm": repair.largest_move_mm,
            "largest_vertex_move_mm": repair.largest_vertex_move_mm,
            "steps": [{"weak_points": int(step.weak_points), "least_force_of_f_min": step.least_force,
                       "least_floor_of_f_min": step.least_floor, "vertices": bool(step.vertices),
                       "fresh_mesh": bool(step.fresh_mesh)} for step in repair.steps],
            "blocked": [{"tiles": [int(t) for t in contact.tiles], "reason": contact.reason}
                        for contact in repair.blocked],
            "suggestions": list(repair.suggestions)}


def _layout(layout: Any) -> dict:
    return {"converged": bool(layout.converged),
            "collision_rounds": int(layout.collision_rounds),
            "separations": int(layout.separations),
            "largest_violation_mm": layout.largest_violation_mm,
            "energies": {name: float(value) for name, value in layout.energies.items()}}


def _solids(outcome: Any) -> dict:
    solids = outcome.solids
    return {"tiles": int(solids.tiles), "invalid": len(solids.unsound),
            "volume_cm3": solids.tile_volume_mm3 / 1000,
            "min_clearance_flat_mm": solids.min_clearance_flat_mm,
            "max_overlap_actuated_mm3": solids.max_overlap_actuated_mm3}


def _print(outcome: Any, files: dict[str, int]) -> dict:
    solids = outcome.solids
    return {"bbox_mm": [float(x) for x in solids.bbox_mm], "bodies": int(solids.bodies),
            "pieces": int(solids.pieces),
            "tile_volume_cm3": solids.tile_volume_mm3 / 1000,
            "support_volume_cm3": solids.support_volume_mm3 / 1000,
            "anchor_volume_cm3": solids.anchor_volume_mm3 / 1000,
            "smallest_feature_mm": solids.smallest_feature_mm,
            "files": dict(files)}


def _pin_warnings(outcome: Any) -> list[dict]:
    _, sides = small_pins(outcome)
    return [{"what": f"the {side} pin has {area:.3g} mm2, less than A_pin_min",
             "kind": "small_pin", "tiles": [int(tile)], "area_mm2": area, "side": side}
            for tile, side, area in sides]


def _hinge_warnings(outcome: Any) -> list[dict]:
    hinges = [int(k) for k in outcome.figures.hinges]
    if not hinges:
        return []
    return [{"what": f"{len(hinges)} contacts are only a hinge: nothing but the front edge touches",
             "kind": "hinge", "tiles": [], "contacts": hinges}]
