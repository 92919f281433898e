# SPDX-License-Identifier: LGPL-2.1-or-later
"""The formats of design.json and report.json, field by field, and the files of a whole design."""

import json
import math

NUMBER, COUNT, TEXT = "number", "count", "text"

FILES = {"design.json", "report.json", "report.html", "NAME.FCStd", "NAME-tiles.step",
         "NAME-support.step", "NAME-anchors.step", "NAME-print.step", "NAME-tiles.stl",
         "NAME-support.stl", "NAME-anchors.stl", "NAME-print.3mf", "NAME-actuated.step"}

REPORT = {
    "format": TEXT, "version": COUNT, "name": TEXT, "title": TEXT, "status": TEXT, "tiles": COUNT,
    "contacts": COUNT, "cuts": COUNT, "valid": None, "holds": None, "reasons": list, "warnings": list,
    "area": {"actuated_cm2": NUMBER, "flat_cm2": NUMBER, "ratio": NUMBER},
    "constraints": {"max_rigidity_mm": NUMBER, "max_gap_violation_mm": NUMBER,
                    "max_pin_bound_violation_mm": NUMBER, "pin_sides_below_area": COUNT,
                    "overlaps": COUNT},
    "stages": list, "peak_memory_mb": NUMBER, "software": {"curveups": TEXT},
}
OPTIONAL = {
    "physics": {"triangles": COUNT, "free_vertices": COUNT, "newton_iterations": [COUNT, COUNT],
                "newton_iterations_coarse": [COUNT, COUNT],
                "newton_iterations_fine": [COUNT, COUNT], "converged": bool,
                "residual": NUMBER, "wrinkled_fraction": NUMBER,
                "force_balance": NUMBER, "torque_balance": NUMBER, "normal_force_error": NUMBER,
                "membrane_clearance_mm": NUMBER},
    "contact_forces": {"unit": TEXT, "normal_mean": NUMBER, "normal_min": NUMBER, "f_min": NUMBER,
                       "points_below_f_min": COUNT, "invalid_contacts": list,
                       "friction_ratio_mean": NUMBER, "friction_ratio_max": NUMBER},
    "unilateral": {"feasible": bool, "friction_coefficient": NUMBER, "floor": NUMBER,
                   "largest_floor": NUMBER, "feasible_at_bump_tips": None},
    "deviation": {"mean_mm": NUMBER, "rms_mm": NUMBER, "max_mm": NUMBER, "hausdorff_mm": NUMBER},
    "solids": {"tiles": COUNT, "invalid": COUNT, "volume_cm3": NUMBER,
               "min_clearance_flat_mm": None, "max_overlap_actuated_mm3": NUMBER},
    "clearances": {"min_flat_mm": None, "max_overlap_actuated_mm3": NUMBER},
    "settled": {"friction_coefficient": NUMBER, "hold_tolerance_mm": NUMBER, "converged": bool,
                "normal_mean": NUMBER, "normal_min": NUMBER, "element_change": NUMBER,
                "open_contacts": list, "largest_slip_mm": NUMBER, "drift_mm": NUMBER,
                "scan": {name: NUMBER for name in ("mean_mm", "rms_mm", "p95_mm", "max_mm",
                                                   "hausdorff_mm")}},
    "friction_needed": {"coefficient": None, "tiles": list},  # a number, or null where none is enough
    "margin": {"mode": TEXT, "mismatch_percent": NUMBER, "friction_coefficient": NUMBER, "met": None},
    "actuation": {"friction_coefficient": NUMBER, "contacts": COUNT, "stopped": bool, "relaxed": dict,
                  "by_itself": dict, "shaken": dict, "pressed": dict, "spread": dict},
    "print": {"bbox_mm": list, "bodies": COUNT, "tile_volume_cm3": NUMBER,
              "support_volume_cm3": NUMBER, "anchor_volume_cm3": NUMBER,
              "smallest_feature_mm": NUMBER, "overhang_mm": NUMBER, "files": dict,
              "glue": {"first": TEXT, **{f"{side}_{what}_mm2": NUMBER for side in ("front", "back")
                                         for what in ("pins", "anchors", "support")}}},
}
STRETCH = {"scale_spread": NUMBER, "area_ratio": NUMBER, "energy_per_contact": NUMBER,
           "spring_mean": NUMBER, "slack_springs": COUNT}
STAGES = ("remesh", "target smoothing", "pieces", "cuts", "pin smoothing", "flatten", "layout", "verify",
          "refine", "settle", "actuate", "solids", "check", "export")


def check(value, expected, where):
    if isinstance(expected, dict):
        assert isinstance(value, dict), where
        for name, inner in expected.items():
            assert name in value, f"{where}.{name}"
            check(value[name], inner, f"{where}.{name}")
    elif isinstance(expected, list):
        assert isinstance(value, list) and len(value) == len(expected), (where, value)
        for item, inner in zip(value, expected):
            check(item, inner, where)
    elif expected == NUMBER:
        assert isinstance(value, (int, float)) and math.isfinite(value), (where, value)
    elif expected == COUNT:
        assert type(value) is int and value >= 0, (where, value)
    elif expected == TEXT:
        assert isinstance(value, str) and value, (where, value)
    elif isinstance(expected, type):
        assert isinstance(value, expected), (where, value)


def check_report(report):
    check(report, REPORT, "report")
    for name, block in OPTIONAL.items():
        if name in report:
            check(report[name], block, name)
    if "solids" in report and report["tiles"] > 1:  # one tile has nothing to be clear of
        check(report["solids"]["min_clearance_flat_mm"], NUMBER, "solids.min_clearance_flat_mm")
    if "unilateral" in report:  # unknown only where there are no bumps
        assert report["unilateral"]["feasible_at_bump_tips"] in (True, False, None)
    assert report["format"] == "curveups-report" and report["version"] == 1
    assert report["status"] in ("complete", "stopped")
    assert report["valid"] in (True, False, None) and report["holds"] in (True, False, None)
    assert report["holds"] is None or "settled" in report
    assert (report["valid"] is True) == (report["reasons"] == [])
    for warning in report["warnings"]:
        assert warning["what"] and isinstance(warning["tiles"], list)
        assert all(0 <= tile < report["tiles"] for tile in warning["tiles"])
    if "layout" in report and "stretch" in report["layout"]:
        check(report["layout"]["stretch"], STRETCH, "layout.stretch")
    for cut in report.get("suggested_cuts", []):
        check(cut, {"edges": list, "length_mm": NUMBER, "reason": TEXT, "predicted": dict}, "cut")
        assert cut["edges"] and all(a != b for a, b in cut["edges"]) and cut["applied"] in (True, False)
        for figures in (cut["predicted"]["before"], cut["predicted"]["after"]):
            if figures is not None:
                check(figures, STRETCH, "predicted")
    for stage in report["stages"]:
        assert stage["name"] in STAGES and stage["seconds"] >= 0 and stage["iterations"] >= 0


def check_design(design):
    assert design["format"] == "curveups-design" and design["version"] == 1
    V, F, T, q = (design[name] for name in "VFTq")
    assert all(len(row) == 3 and all(math.isfinite(x) for x in row) for row in V)
    assert len(F) == len(T) == len(q)
    assert all(len(row) == 3 and all(0 <= v < len(V) for v in row) for row in F)
    assert all([len(p) for p in tile] == [2, 2, 2] for tile in T)
    assert all([len(p) for p in tile] == [3, 3] for tile in q)
    for name in ("L", "H_body", "H_pin", "tau", "d_gap_min", "p_min", "p_max", "A_pin_min"):
        assert name in design["parameters"]
    for tile in T:  # counter-clockwise from the front
        (ax, ay), (bx, by), (cx, cy) = tile
        assert (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > 0


def read_run(folder):
    """design.json and report.json of a finished run, both checked."""
    design, report = (json.loads((folder / f"{name}.json").read_bytes()) for name in ("design", "report"))
    check_design(design)
    check_report(report)
    return design, report
