# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sizes that the program chooses: L and H_body as auto, a target scaled to a size."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from curveups.base.errors import CurveUpsError, Stopped
from curveups.base.native import native
from curveups.project import size_choice
from curveups.stages import smoothing as pin_smoothing
from curveups.stages.cut_request import CutRequest
from curveups.stages.feasibility import examine
from curveups.stages.stage import Job
from made import project, sheet, tent
from shapes import sphere


def dome(radius=60.0, parts=30):
    return sheet(lambda x, y: np.sqrt(radius ** 2 - x * x - y * y), 25, parts)


def choose(of, *names):
    return size_choice.choose(of, names, Job())


def test_the_largest_length_within_the_deviation_is_solved():
    of = project(*dome(), maximum_deviation=0.3)
    choice = choose(of, "L")
    L = choice.values["L"]
    assert choice.valid and str(choice.tried[-1]) == f"tried L = {L:g} mm: valid"
    # What was made to try it is what a design with it is.
    assert choice.project.out_of_date("verification") == () and choice.project.parameters.get("L") == L
    made = choice.project.run(("target", "verification"))
    assert made["target"].chord_error <= 0.3 and made["verification"].valid
    assert of.parameters.get("L") == 7 and of.latest("layout") is None
    beyond = project(*dome(), L=1.2 * L).run(("target",))["target"]
    assert beyond.chord_error > 0.3
    assert choose(project(*dome(), maximum_deviation=0.6), "L").values["L"] > L


def test_thickness_and_both():
    choice = choose(project(*dome(), L=8.0), "H_body")
    assert choice.valid and choice.values == {"H_body": 3.4} and len(choice.tried) == 1
    both = choose(project(*dome(), maximum_deviation=0.3), "L", "H_body")
    assert both.valid and set(both.values) == {"L", "H_body"}
    assert both.values["H_body"] <= float(f"{3 / 7 * both.values['L']:.2g}")


def test_a_deviation_out_of_reach_is_refused_with_what_was_tried():
    V, F = dome(26 * 2 ** 0.5, 40)  # a steep rim
    with pytest.raises(CurveUpsError, match="no size was found that works: tried L = .*from the surface"):
        choose(project(V, F, maximum_deviation=1e-3), "L")


def test_the_least_length_is_tried_once():
    V, F = dome(26 * 2 ** 0.5, 40)
    with pytest.raises(CurveUpsError, match="no size was found that works: ") as told:
        choose(project(V, F, maximum_deviation=0.09), "L")
    *tried, pins = told.value.what.split("; ")
    assert len(set(tried)) == len(tried) > 1 and pins.startswith("pins of A_pin_floor have no room")


def test_thinner_tiles_are_solved_until_a_design_is_valid():
    """Margins let thick tiles pass, and membranes cut into them."""
    V, F = tent(5, 9, 24)
    choice = choose(project(V, F[:, ::-1], L=10.0), "H_body")
    *refused, last = choice.tried
    assert choice.valid and last.kind == "tried.valid"
    assert refused and {finding.figures["why"][0].kind for finding in refused} == {"membrane.cuts"}
    tried = [finding.figures["sizes"][0].figures["value"] for finding in choice.tried]
    assert tried == sorted(tried, reverse=True) and tried[-1] == choice.values["H_body"]
    said = [str(one) for one in choice.findings()]
    assert said[0].startswith(f"tried H_body = {tried[0]:g} mm: not valid, the back membrane would cut")
    assert said[-1] == f"tried H_body = {tried[-1]:g} mm: valid"


def test_sizes_that_margins_refuse_are_not_solved():
    V, F = tent(7, 9, 24)
    with pytest.raises(CurveUpsError, match="tried H_body = 4.3 mm: not valid, 2 of 64 tiles can't be made"):
        choose(project(V, F[:, ::-1], L=10.0), "H_body")


def test_what_no_thickness_mends_is_said():
    with pytest.raises(CurveUpsError, match="pins of A_pin_floor have no room at L 2.4 mm, H_body 1 mm"):
        choose(project(*sheet(lambda x, y: 0.0, 10, 4), L=2.4), "H_body")


def test_the_command_line_says_where_no_size_gives_a_valid_design(curveups, cap, tmp_path):
    """Friction of this coefficient holds nothing."""
    ran = curveups("design", cap, "-o", tmp_path, "--set", "H_body=auto", "friction_coefficient=0.01",
                   "run_repair=off", "--no-solids")
    assert ran.status == 1, ran.err
    assert "no design with the sizes that were tried is valid" in ran.err
    values = json.loads((tmp_path / "design.json").read_text("utf-8"))["parameters"]
    assert f"H_body = {values['H_body']:g} mm is chosen" in ran.err
    assert ran.err.count("tried H_body = ") > 1, ran.err


def test_a_closed_surface_is_opened_before_sizes_are_tried():
    of = project(*sphere(spacing=4.0), L=14.0, run_verification=False)
    of.give("cut request", CutRequest(suggested=1))
    choice = choose(of, "H_body")
    request = choice.project.latest("cut request")
    assert choice.valid and len(request.edges) and not request.suggested


def test_a_choice_can_be_stopped():
    with pytest.raises(Stopped):
        size_choice.choose(project(*dome(), L=8.0), ("H_body",), Job(lambda what, fraction: what != "layout"))


def test_a_mesh_that_is_given_has_its_own_length():
    of = project(*dome(parts=8), remesh=False)  # sides of 6.3 to 9 mm
    L = of.run(("target",))["target"].own_length
    assert 6 < L < 9 and L != of.parameters.get("L")
    values = choose(of, "H_body").values
    assert values["H_body"] <= L * 3 / 7 + 0.05
    with pytest.raises(CurveUpsError, match="L can't be auto"):
        choose(of, "L")


def test_auto_on_the_command_line(curveups, cap, tmp_path):
    ran = curveups("design", cap, "-o", tmp_path, "--set", "L=auto", "H_body=auto", "maximum_deviation=0.8",
                   "run_verification=off", "--no-solids")
    assert ran.status == 0, ran.err
    values = json.loads((tmp_path / "design.json").read_text("utf-8"))["parameters"]
    assert f"L = {values['L']:g} mm is chosen" in ran.err
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert report["target"]["sagitta_mm"] <= 0.8
    assert curveups("design", cap, "-o", tmp_path / "b", "--no-remesh", "--set", "L=auto").status == 2
    assert curveups("design", cap, "-o", tmp_path / "b", "--set", "tau=auto").status == 2


def test_where_a_quarter_of_the_pins_has_no_room_none_is_made(monkeypatch):
    """Each facet of the dome is two tiles: moving thousands of vertices took minutes, and gave no room."""
    asked = []
    watched = SimpleNamespace(target_figures=native.target_figures, smooth_for_pins=lambda *given: (
        asked.append(len(given[1])), native.smooth_for_pins(*given))[1])
    monkeypatch.setattr(pin_smoothing, "native", watched)
    of, edges = project(*dome(parts=20), crease_angle=1), np.zeros((0, 2), np.int32)
    target = of.run(("target",))["target"]
    short = [one for one in examine(target.V, target.F, edges, of.parameters).blocked
             if one.obstacle == "pin"]
    assert len(short) > 0.25 * 2 * len(target.F)
    assert not of.run(("feasibility",))["feasibility"].feasible and not asked
    wide = project(*dome(parts=20)).run(("target",))["target"]
    pin_smoothing.smooth_for_pins(wide.V, wide.F, edges, of.parameters, Job())
    assert asked == [len(wide.F)]
