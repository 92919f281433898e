# SPDX-License-Identifier: LGPL-2.1-or-later
"""Room for pins before the layout, repair after verification, and the second verdict."""

import json
import math

import numpy as np
import pytest
from running import dome
from schema import check_design, check_report


@pytest.fixture(scope="module")
def steep(tmp_path_factory):
    """A dome whose centre is pulled out: folds there leave pins little room."""
    path = tmp_path_factory.mktemp("targets") / "steep.obj"
    lines = dome(3, radius=30.0).splitlines()
    lines[0] = "v 0.0 0.0 32.0"
    path.write_text("\n".join(lines) + "\n")
    return path


@pytest.fixture(scope="module")
def patch(tmp_path_factory):
    """A dome over a rhombus: its contacts at the sharp corners are the weak ones."""
    n, edge, radius = 4, 7.0, 40.0
    vertices, faces = [], []
    for r in range(n + 1):
        for c in range(n + 1):
            x = edge * (c + 0.5 * (r % 2) - 0.5 * n)
            y = edge * math.sqrt(0.75) * (r - 0.5 * n)
            vertices.append((x, y, math.sqrt(radius**2 - x * x - y * y) - radius))
    for r in range(n):
        for c in range(n):
            a = r * (n + 1) + c
            b, d, e = a + 1, a + n + 1, a + n + 2
            faces += [(a, e, d), (a, b, e)] if r % 2 else [(a, b, d), (b, e, d)]
    path = tmp_path_factory.mktemp("targets") / "patch.obj"
    path.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices)
                    + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces))
    return path


def run(curveups, target, folder, *settings, status=0):
    done = curveups("design", target, "-o", folder, "--no-remesh", "--no-solids", *settings)
    assert done.status == status, done.err
    report = json.loads((folder / "report.json").read_text("utf-8"))
    design = json.loads((folder / "design.json").read_text("utf-8"))
    check_report(report)
    check_design(design)
    return report, design


def test_vertices_make_room_for_pins(curveups, steep, tmp_path):
    setting = ("--set", "A_pin_min=9")
    report, design = run(curveups, steep, tmp_path / "off", *setting, "--set", "run_verification=off")
    small = report["constraints"]["pin_sides_below_area"]
    assert small > 0 and "pin_smoothing" not in report and "target" not in design
    assert report["deviation"]["max_mm"] < 1e-9

    report, moved = run(curveups, steep, tmp_path / "on", *setting)
    pin_smoothing = report["pin_smoothing"]
    assert len(pin_smoothing["pin_sides"]) == small and pin_smoothing["remaining"] == 0
    assert report["constraints"]["pin_sides_below_area"] == 0
    assert all(side["area_before_mm2"] < 9 for side in pin_smoothing["pin_sides"])
    assert len(pin_smoothing["moved_vertices"]) == np.count_nonzero(
        np.any(np.array(moved["V"]) != np.array(moved["target"]["V"]), axis=1))
    assert pin_smoothing["moved_vertices"][0]["mm"] == pytest.approx(pin_smoothing["largest_move_mm"])
    # What moved, and from where, is in the design; how far, in the report.
    distance = np.linalg.norm(np.array(moved["V"]) - np.array(moved["target"]["V"]), axis=1)
    assert np.isclose(distance.max(), pin_smoothing["largest_move_mm"], atol=1e-9)
    assert 0 < report["deviation"]["max_mm"] <= distance.max() + 1e-9
    assert moved["target"]["V"] == design["V"]


def test_a_higher_floor_is_repaired(curveups, patch, tmp_path):
    first, _ = run(curveups, patch, tmp_path / "first")
    forces = first["contact_forces"]
    ratio = 1.25 * forces["normal_min"] / forces["normal_mean"]
    report, _ = run(curveups, patch, tmp_path / "second", "--set", f"f_min_ratio={ratio}")
    assert report["repair"]["status"] == "valid" and report["valid"] is True
    steps = report["repair"]["steps"]
    assert steps[0]["weak_points"] > 0 and steps[-1]["weak_points"] == 0
    assert steps[0]["fresh_mesh"] and steps[-1]["fresh_mesh"]
    assert report["repair"]["mended"] and all(len(pair) == 2 for pair in report["repair"]["mended"])
    assert report["contact_forces"]["points_below_f_min"] == 0
    stages = [stage["name"] for stage in report["stages"]]
    assert stages.index("refine") < stages.index("verify")  # the last verdict is the repaired design's


def test_a_design_that_repair_leaves_as_it_is_has_the_whole_verdict(curveups, patch, tmp_path):
    def asked(ratio, *more):
        return run(curveups, patch, tmp_path / "out", "--set", f"f_min_ratio={ratio}", *more, status=1)[0]

    # Without repair, and at a floor that is out of any reach: what the layout lacks was known already.
    for report in (asked(0.5, "run_repair=off"), asked(0.99)):
        assert report["valid"] is False and any("push too weakly" in reason for reason in report["reasons"])
        assert report["unilateral"]["largest_floor"] > 0
        assert report["contact_forces"]["points_below_f_min"] > 0
