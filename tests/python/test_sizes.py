# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sizes that the program chooses: L and H_body as auto, a target scaled to a size."""

import json
import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from curveups.targets.cad_files import Read
from curveups.base.errors import CurveUpsError
from curveups.base.findings import Finding
from curveups.base.native import native
from curveups.project.project import Project
from curveups.stages import feasibility, pin_smoothing, size_search, sizes
from curveups.stages.cut_request import CutRequest
from curveups.stages.stage import Job
from curveups.stages.surface import Source
from curveups.stages.trial import trial
from curveups.stages.trial_layout import FAILED, PASSED, UNDECIDED, TrialLayout


def dome(radius=60.0, parts=30):
    steps = np.linspace(-25, 25, parts + 1)
    V = np.array([(x, y, np.sqrt(radius ** 2 - x * x - y * y)) for y in steps for x in steps])
    F = []
    for j in range(parts):
        for i in range(parts):
            a = j * (parts + 1) + i
            F += [(a, a + 1, a + parts + 2), (a, a + parts + 2, a + parts + 1)]
    return V, np.array(F, np.int32)


def tent(height):
    """A ridge between two tips, 16 mm long, on a square of 48 mm."""
    steps = np.arange(-24, 25, 2.0)
    V = np.array([(x, y, height * max(0.0, 1 - np.hypot(max(abs(x) - 8, 0), y) / 9))
                  for y in steps for x in steps])
    a = (25 * np.arange(24)[:, None] + np.arange(24)).reshape(-1)
    F = np.stack([a, a + 1, a + 26, a, a + 26, a + 25], axis=1).reshape(-1, 3)
    return V, F.astype(np.int32)


def project(V, F, **values):
    parameters = native.Parameters()
    for name, value in values.items():
        parameters.set(name, value)
    source = Source("made", stamp="made", will_be_cut=True, read=lambda deflection, choice: Read(V, F))
    return Project("made", parameters, {"source": source, "cut request": CutRequest()}, "made")


def chosen(of, *names):
    made = sizes.choose(of.inputs(sizes.READS, Job()), names, Job())
    assert made.trial != FAILED
    return made.values


def test_the_largest_length_within_fidelity():
    fidelity = 0.3
    of = project(*dome(), maximum_deviation=fidelity)
    L = chosen(of, "L")["L"]
    made = project(*dome(), L=L).run(("target", "feasibility"))
    assert made["target"].chord_error <= fidelity and made["feasibility"].feasible
    beyond = project(*dome(), L=1.2 * L).run(("target",))["target"]
    assert beyond.chord_error > fidelity
    assert chosen(project(*dome(), maximum_deviation=2 * fidelity), "L")["L"] > L


def test_thickness_and_both():
    of = project(*dome(), L=8.0)
    H_body = chosen(of, "H_body")["H_body"]
    assert 8 / 7 <= H_body <= 8 * 3 / 7
    assert project(*dome(), L=8.0, H_body=H_body).run(("feasibility",))["feasibility"].feasible
    both = chosen(project(*dome(), maximum_deviation=0.3), "L", "H_body")
    assert both["H_body"] <= both["L"] * 3 / 7
    assert project(*dome(), **both).run(("feasibility",))["feasibility"].feasible


def test_a_fidelity_out_of_reach_is_refused():
    V, F = dome(26 * 2 ** 0.5, 40)  # a steep rim
    with pytest.raises(CurveUpsError, match="no L does"):
        chosen(project(V, F, maximum_deviation=1e-3), "L")


def test_a_trial_layout_overrules_estimates():
    V, F = tent(7)
    of, said = project(V, F[:, ::-1], L=10.0, maximum_deviation=3), []
    job = Job(lambda what, _: said.append(what) or True)
    made = sizes.choose(of.inputs(sizes.READS, job), ("L", "H_body"), job)
    tried = [what for what in dict.fromkeys(said) if "H_body" in what and "H_pin" not in what]
    assert len(tried) == 2 and made.trial == PASSED, (tried, made)
    first, then = ([float(one) for one in re.findall(r"[\d.]+", what)] for what in tried)
    assert then == [made.values["L"], made.values["H_body"]]
    for (L, H_body), shown in ((first, "failed"), (then, "passed")):
        of = project(V, F[:, ::-1], L=L, H_body=H_body)
        assert of.run(("trial layout",))["trial layout"].shown == shown


def test_the_choice_says_where_no_design_is_valid(monkeypatch):
    weak = TrialLayout((), PASSED, beyond=(Finding("no_pressure"),))
    tried = []

    def chosen(thickest_valid):
        def decide(inputs, found, job, values, steps, begun):
            tried.append(values["H_body"])
            return weak if values["H_body"] > thickest_valid else TrialLayout((), PASSED)

        monkeypatch.setattr(size_search, "decide", decide)
        return sizes.choose(project(*dome(), L=8.0).inputs(sizes.READS, Job()), ("H_body",), Job())

    made = chosen(0.0)
    assert len(tried) == 3 and made.values["H_body"] == tried[0] > tried[1] > tried[2]
    assert made.trial == PASSED and made.beyond == weak.beyond
    made = chosen(tried[1])
    assert made.values["H_body"] == tried[1] == tried[-1] and not made.beyond


def test_the_command_line_says_where_what_is_chosen_gives_no_valid_design(curveups, cap):
    """Glue of this strength holds nothing."""
    ran = curveups("check", cap, "--set", "H_body=auto", "glue_strength=0.05")
    assert ran.status == 0, ran.err
    assert "warning: a design with these sizes is not valid, and no smaller sizes were found" in ran.err
    assert "more than it withstands (0.05 MPa)" in ran.err, ran.err
    assert "warning" not in curveups("check", cap, "--set", "H_body=auto").err


def test_where_trial_layouts_of_all_sizes_fail_the_choice_says_so(curveups, tmp_path):
    """At this length no thickness that is tried lets the membranes clear the tips."""
    V, F = tent(5)
    for H_body in (4.1, 2.0, 0.6):
        of = project(V, F, L=10.0, H_body=H_body)
        made = of.run(("trial layout", "verification"))
        repaired = made["repair"]
        assert made["trial layout"].shown == "failed"
        # What repair ends with is what verification finds of it.
        cuts = [one for one in made["verification"].reasons() if one.kind == "membrane.cuts"]
        assert cuts and list(repaired.cuts) == cuts
        # It ends once no pin can give way, though forces could become larger still.
        assert repaired.status == "blocked" and not repaired.blocked
        assert repaired.block["steps"][-1]["weak_points"] == 0
        tried = trial(of.inputs(("target",), Job()), {}, Job(), [60])
        assert tried["repair"].cuts == repaired.cuts and "verification" not in tried
    of = project(V, F, L=10.0)
    made = sizes.choose(of.inputs(sizes.READS, Job()), ("H_body",), Job())
    assert made.trial == FAILED and 10 / 7 <= made.values["H_body"] <= 30 / 7

    target = tmp_path / "tent.obj"
    target.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in V)
                      + "".join(f"f {a} {b} {c}\n" for a, b, c in F + 1))
    ran = curveups("check", target, "-o", tmp_path / "check", "--set", "L=10", "H_body=auto")
    assert ran.status == 1, ran.err
    said = f"H_body = {made.values['H_body']:g} mm is chosen\nwarning: a trial layout with these sizes failed"
    assert said in ran.err, ran.err


@pytest.fixture
def search(monkeypatch):
    """Estimates find everything feasible; `tries` says what trial layouts find, by their parameters."""
    monkeypatch.setattr(size_search, "sizes_do", lambda *given: True)
    of = project(*dome(), L=8.0, H_body=3.0, H_pin=1.0)
    inputs = of.inputs(sizes.READS, Job())

    def made(tries):
        def decide(inputs, found, job, values, steps, begun):
            return tries({name: values.get(name, of.parameters.get(name))
                          for name in ("L", "H_body", "H_pin")})

        monkeypatch.setattr(size_search, "decide", decide)
        return (size_search.SizeSearch(inputs["target"], inputs["cut request"], of.parameters, Job()),
                replace(inputs, elsewhere=lambda values, goals, job: {"feasibility": None}))

    return made


def failed():
    return TrialLayout((feasibility.Obstacle(Finding.about("gap", [0])),), FAILED)


def test_sizes_that_fail_are_left_out_of_their_kind_alone(search):
    tried = []

    def tries(values):
        tried.append(values)
        return TrialLayout((), PASSED) if values["H_pin"] < 1 else failed()

    of, inputs = search(tries)
    assert of.named(lambda: (("H_body", of.largest_thickness(8, 3)),), inputs) is None
    thick = [values["H_body"] for values in tried]
    assert len(thick) == 3 and thick[0] == 3
    assert thick[0] / thick[1] > 1.15 and thick[1] / thick[2] > 1.15 ** 2
    assert not any(of.tried[8.0, one, 1.0].feasible for one in thick)
    # Heights are looked for from the start, however near to those of thicknesses that failed.
    found, layout = of.named(lambda: (("H_pin", of.height_of_pins(8, 3)),), inputs)
    assert [values["H_pin"] for values in tried[3:]] == [1.1, 1.3, 0.95] and layout.shown == PASSED
    # The near end of what is below.
    assert found == (("H_pin", 0.95),) and of.tried[8.0, 3.0, 0.95].feasible


def test_a_target_that_is_refused_with_some_sizes_is_tried_with_others(search):
    def tries(values):
        if values["H_body"] > 2:
            raise CurveUpsError("no", "made", "")
        return TrialLayout(())

    of, inputs = search(tries)
    found, layout = of.named(lambda: (("H_body", of.largest_thickness(8, 3)),), inputs)
    assert dict(found)["H_body"] <= 2 and layout.shown == ""  # no trial layout has been made


def test_what_is_undecided_comes_after_what_passes(search):
    """Repair had not ended for the largest thickness."""
    of, inputs = search(lambda values: TrialLayout((), UNDECIDED if values["H_body"] > 2 else PASSED))
    found, layout = of.named(lambda: (("H_body", of.largest_thickness(8, 3)),), inputs)
    assert dict(found)["H_body"] <= 2 and layout.shown == PASSED
    of, inputs = search(lambda values: TrialLayout((), UNDECIDED))
    largest = (("H_body", 3.0),)
    found = of.named(lambda: (("H_body", of.largest_thickness(8, 3)),), inputs)
    assert found == (largest, TrialLayout((), UNDECIDED))


def test_valid_designs_come_before_those_that_only_lie_flat(search):
    glue = TrialLayout((), PASSED, beyond=(Finding("no_pressure"),))
    of, inputs = search(lambda values: glue if values["H_body"] > 2 else TrialLayout((), PASSED))

    def largest():
        return (("H_body", of.largest_thickness(8, 3)),)

    found, layout = of.named(largest, inputs)
    assert dict(found)["H_body"] <= 2 and not layout.beyond
    # The largest where none is valid, and after undecided ones.
    of, inputs = search(lambda values: TrialLayout((), UNDECIDED) if values["H_body"] > 2.9 else glue)
    found, layout = of.named(largest, inputs)
    assert 2 < dict(found)["H_body"] < 2.9 and layout == glue
    of, inputs = search(lambda values: TrialLayout((), PASSED) if values["H_pin"] > 1 else glue)
    assert of.much_thinner(8, 3, inputs) == ((("H_body", 1.5), ("H_pin", 1.5)), TrialLayout((), PASSED))
    of, inputs = search(lambda values: glue if values["H_body"] < 1 else failed())
    assert of.much_thinner(8, 3, inputs) == ((("H_body", 0.75),), glue)


def test_what_is_in_the_way_without_a_trial_is_none_that_does(search):
    blocked = feasibility.Obstacle(Finding.about("gap", [0]))
    of, inputs = search(lambda values: TrialLayout((blocked,)))
    assert of.named(lambda: (("H_body", of.largest_thickness(8, 3)),), inputs) is None


def test_lengths_are_not_below_the_thickness(search):
    """No trial layout is made of tiles that are thicker than they are long."""
    of, _ = search(lambda values: TrialLayout(()))
    assert min(of.lengths(8.0, 7.0)) >= 7.0 and min(of.lengths(8.0, 1.0)) < 7.0
    assert min(of.lengths(8.0, 9.0)) == 8.0  # as it is set
    assert of.range_of_lengths(8.0, 7.0)[0] >= 7.0


def test_ranges_end_at_values_that_were_found_bad():
    values, bad = list(range(20)), {16, *range(12)}

    def good(value):
        return value not in bad

    start = size_search._nearest(values, 10, good)
    assert start == 19
    low, high = (values[size_search._reach(values, 10, start, good, step)] for step in (-1, 1))
    assert (low, high) == (17, 19)
    assert size_search._nearest(values, 10, lambda value: value in (0, 19)) == 19
    assert size_search._nearest(values, 10, lambda value: value == 0) == 0
    assert size_search._nearest(values, 10, lambda value: False) is None


def test_a_mesh_that_is_given_has_its_own_length():
    V, F = dome(parts=30)  # sides of 1.7 to 2.4 mm
    source = Source("made", stamp="made", remesh=False, read=lambda deflection, choice: Read(V, F))
    of = Project("made", native.Parameters(), {"source": source, "cut request": CutRequest()}, "made")
    L = of.run(("target",))["target"].own_length
    assert 1.5 < L < 2.5 < of.parameters.get("L")
    try:
        H_body = sizes.choose(of.inputs(sizes.READS, Job()), ("H_body",), Job()).values["H_body"]
    except CurveUpsError as error:
        assert f"for L = {L:g} mm" in error.what
    else:
        assert H_body <= L * 3 / 7


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
    """Each facet of the dome is two tiles, which no thickness gives room: the search took minutes."""
    asked = []
    watched = SimpleNamespace(tile_margins=native.tile_margins, smooth_for_pins=lambda *given: (
        asked.append(len(given[1])), native.smooth_for_pins(*given))[1])
    monkeypatch.setattr(pin_smoothing, "native", watched)
    of, edges = project(*dome(parts=20), crease_angle=1), np.zeros((0, 2), np.int32)
    target = of.run(("target",))["target"]
    short = [one for one in feasibility.examine(target.V, target.F, edges, of.parameters, Job()).blocked
             if one.obstacle == "pin"]
    assert len(short) > 0.25 * 2 * len(target.F)
    with monkeypatch.context() as within:
        within.setattr(feasibility, "smooth_target", None)  # nor by mending, which advice would name
        assert not feasibility.sizes_do(target.V, target.F, edges, of.parameters, Job())
        assert feasibility.mending(target.V, target.F, edges, of.parameters, Job()) is None and not asked
    wide = project(*dome(parts=20)).run(("target",))["target"]
    pin_smoothing.smooth_for_pins(wide.V, wide.F, edges, of.parameters, Job())
    assert asked == [len(wide.F)]
