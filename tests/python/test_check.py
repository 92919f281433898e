# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups check`: what of a target can be tiles."""

import json
import math
import sys
from dataclasses import replace
from pathlib import Path

import cad
import numpy as np
import pytest
from curveups.targets.cad_files import Read
from curveups.base.errors import CurveUpsError, Stopped
from curveups.base.findings import Finding
from curveups.base.native import native
from curveups.project.project import Project
from curveups.report import check
from curveups.stages import advice, asked_by, feasibility, pin_smoothing, size_search, trial_layout
from curveups.stages.cut_request import CutRequest
from curveups.stages.feasibility import Obstacle, examine
from curveups.stages.stage import Job
from curveups.stages.surface import Source
from shapes import obj_text

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))
import check_agrees  # noqa: E402
import held_out  # noqa: E402

NO_CUTS = np.zeros((0, 2), np.int32)


def obj(V, F):
    return ("".join("v %r %r %r\n" % tuple(map(float, v)) for v in V)
            + "".join("f %d %d %d\n" % tuple(int(i) + 1 for i in f) for f in F))


def sheet(height, size=30.0, parts=30):
    """A square sheet over the plane."""
    steps = np.linspace(-size, size, parts + 1)
    V = np.array([(x, y, height(x, y)) for y in steps for x in steps])
    F = []
    for j in range(parts):
        for i in range(parts):
            a = j * (parts + 1) + i
            F += [(a, a + 1, a + parts + 2), (a, a + parts + 2, a + parts + 1)]
    return V, np.array(F, np.int32)


def cone(slope):
    return sheet(lambda x, y: -slope * math.hypot(x, y))


def tip():
    """A cone of 54 tiles, 6 mm long, which no remesher has a say in. Estimates call it not feasible from a
    slope of 0.37 on, and it is valid up to 0.45."""
    V = [(0.0, 0.0, 0.0)]
    F = []
    for ring in range(1, 4):
        first, inner = len(V), len(V) - max(1, 6 * ring - 6)
        for k in range(6 * ring):
            angle = 2 * math.pi * k / (6 * ring)
            V.append((6 * ring * math.cos(angle), 6 * ring * math.sin(angle), -0.42 * 6 * ring))
            at, within = divmod(k, ring)
            a = inner + (at * (ring - 1) + within) % max(1, 6 * ring - 6)
            F.append((first + k, first + (k + 1) % (6 * ring), a))
            if within < ring - 1:
                F.append((a, first + k + 1, inner + (at * (ring - 1) + within + 1) % (6 * ring - 6)))
    return np.array(V), np.array(F, np.int32)


def project(V, F, remesh=True, **values):
    parameters = native.Parameters()
    for name, value in values.items():
        parameters.set(name, value)
    source = Source("made", stamp="made", remesh=remesh, will_be_cut=True,
                    read=lambda deflection, choice: Read(V, F))
    return Project("made", parameters, {"source": source, "cut request": CutRequest()}, "made")


def test_a_filleted_lid_is_checked_without_a_warning_and_says_what_it_tries(curveups_process, tmp_path):
    """It stood at 97 % while it looked for sizes, and numpy warned."""
    lid = cad.make(tmp_path, "lid")["lid"]
    ran = curveups_process("check", lid, "--set", "L=16", PYTHONWARNINGS="error")
    assert ran.status == 1 and ran.out.startswith("lid: "), (ran.out, ran.err)
    said = ran.err.splitlines()
    assert all(line.startswith("curveups: ") for line in said), ran.err
    tried = [line for line in said if "trying L = " in line]
    assert len(tried) == len(set(tried)) > 8, ran.err


def test_a_sound_target(curveups, cap, tmp_path):
    ran = curveups("check", cap, "--no-remesh", "-o", tmp_path / "out")
    assert ran.status == 0, ran.err
    found = json.loads((tmp_path / "out" / "check.json").read_text("utf-8"))
    assert found["format"] == "curveups-check" and found["version"] == 1
    assert found["feasible"] is True and found["blocked"] == []
    assert [tile["tile"] for tile in found["tiles"]] == list(range(24))
    for tile in found["tiles"]:
        assert tile["fold_margin"] > 0 and 0 < tile["back_scale"] < 1 and tile["stretch"] > 0
        assert all(room > -3 for room in tile["pin_room_mm2"])
    assert found["recommended"]["L"] is None  # the mesh was to be taken as it is
    assert found["recommended"]["H_body"] >= 3
    assert "nothing is in the way" in ran.out and "H_body up to" in ran.out
    assert found["trial"] is None and "these are estimates" in ran.out
    page = (tmp_path / "out" / "check.html").read_text(encoding="utf-8")
    assert "Feasible" in page and "data:image/png;base64," in page
    assert not (tmp_path / "out" / "design.json").exists()
    assert curveups("check", cap, "--no-remesh").out == ran.out  # nothing needs a folder


def test_a_tip_is_named_and_a_higher_pin_clears_it(curveups, tmp_path):
    path = tmp_path / "cone.obj"
    path.write_text(obj(*cone(1.1)))
    ran = curveups("check", path, "-o", tmp_path)
    assert ran.status == 1, ran.err
    found = json.loads((tmp_path / "check.json").read_text("utf-8"))
    assert not found["feasible"] and {one["obstacle"] for one in found["blocked"]} == {"membrane"}
    assert found["trial"] == "failed" and all(one["certain"] for one in found["blocked"])
    assert "a trial layout, made and repaired" in ran.out and "are estimates" not in ran.out
    first = found["blocked"][0]
    assert f"\n  T{first['tile'] + 1:05d}: {first['why']}" in ran.out
    assert 0 < found["mending_would_move_mm"] <= 2 and "with mend=on, which moves" in ran.out
    assert curveups("check", path, "--set", "mend=on").status == 0
    remeshed = project(*cone(1.1)).run(("target",))["target"]
    from_tip = np.linalg.norm(remeshed.V, axis=1)[remeshed.F].min(axis=1)
    assert all(from_tip[one["tile"]] < 7 for one in found["blocked"])
    assert curveups("check", path, "--set", "H_pin=2").status == 0
    height = found["recommended"]["H_pin"]
    assert 1 < height < 2 and f"H_body = 3 mm, H_pin = {height:g} mm does" in ran.out
    assert "H_pin, mm" in (tmp_path / "check.html").read_text(encoding="utf-8")
    assert curveups("check", path, "--set", f"H_pin={height:g}").status == 0


def test_where_estimates_are_in_doubt_a_trial_layout_decides():
    """Estimates call a cone not feasible that is a valid design, and a steeper one feasible that is none."""
    said = project(*tip(), remesh=False).run(("trial layout",))
    assert not said["feasibility"].feasible and said["feasibility"].possible
    assert said["trial layout"].feasible and said["trial layout"].shown == "passed"
    assert project(*tip(), remesh=False).run(("verification",))["verification"].valid
    sharp = held_out.draw(73)
    V, F = np.asarray(sharp[0][0]), np.asarray(sharp[0][1], np.int32)
    said = project(V, F, **{**check_agrees.BASE, **sharp[1]}).run(("trial layout",))
    assert said["feasibility"].feasible and said["trial layout"].shown == "failed"
    blocked = said["trial layout"].blocked
    assert blocked and all(one.certain and one.why.kind == "membrane.cuts" for one in blocked)
    assert said["trial layout"].sag > feasibility.SAG


def test_check_says_where_a_trial_layout_is_not_valid_all_the_same(curveups, tmp_path):
    """Glue that bears nothing is none of the obstacles that check looks for."""
    path = tmp_path / "tip.obj"
    path.write_text(obj(*tip()))
    ran = curveups("check", path, "--no-remesh", "-o", tmp_path / "check", "--set", "glue_strength=0.05")
    assert ran.status == 0, ran.err
    said = json.loads((tmp_path / "check" / "check.json").read_text("utf-8"))
    assert said["feasible"] and said["trial"] == "passed" and len(said["trial_not_valid"]) == 1
    line = f"the design of that layout is not valid all the same: {said['trial_not_valid'][0]}"
    assert line in ran.out and "MPa of shear" in line
    ran = curveups("design", path, "--no-remesh", "-o", tmp_path / "design", "--no-solids", "--set",
                   "glue_strength=0.05")
    report = json.loads((tmp_path / "design" / "report.json").read_text("utf-8"))
    assert ran.status == 1 and said["trial_not_valid"][0] in report["reasons"]
    sound = curveups("check", path, "--no-remesh", "-o", tmp_path / "sound")
    assert "all the same" not in sound.out
    assert json.loads((tmp_path / "sound" / "check.json").read_text("utf-8"))["trial_not_valid"] == []


def test_check_says_which_of_the_sizes_that_it_names_give_no_valid_design(monkeypatch):
    weak = trial_layout.TrialLayout((), "passed", beyond=(Finding("no_pressure"),))
    monkeypatch.setattr(size_search, "decide", lambda inputs, found, job, values, steps, begun: weak)
    found = project(*cone(1.1)).run(asked_by("check"))
    sizes = found["sizes"]
    assert not sizes.as_set and (sizes.L, sizes.H_body, sizes.together) == (None, None, None)
    assert set(sizes.beyond) == {"H_pin", "mend"}
    said = [str(one) for one in check.advice(found)]
    why = str(Finding("no_pressure"))
    for name in (f"H_pin={sizes.H_pin:g}", "mend=on"):
        assert f"with {name} a design is not valid all the same: {why}" in said
    assert check.build_check(found)["recommended"]["not_valid"] == {"H_pin": [why], "mend": [why]}
    more = replace(sizes, L=(9.0, 9.0), H_body=2.0, beyond={"L": weak.beyond, "H_body": weak.beyond})
    said = [str(one) for one in advice.of_check(more, 7.0, 3.0)]
    for name in ("L=9", "H_body=2"):
        assert f"with {name} a design is not valid all the same: {why}" in said

    # Nothing works by itself, and thinner tiles do with higher pins alone.
    def thin_tiles(inputs, found, job, values, steps, begun):
        assert steps
        if values.get("mend") == "on" or values.get("H_body", 3.0) > 1.5 or values.get("H_pin", 1.0) < 1.5:
            return trial_layout.TrialLayout(found.blocked or (blocked,), "failed")
        return weak

    blocked = feasibility.Obstacle(Finding.about("gap", [0]))
    monkeypatch.setattr(size_search, "decide", thin_tiles)
    found = project(*cone(1.1)).run(asked_by("check"))
    sizes = found["sizes"]
    assert sizes.together == (1.5, 1.5) and set(sizes.beyond) == {"together"}
    assert any("with H_body=1.5 with H_pin=1.5 a design" in str(one) for one in check.advice(found))


def test_a_trial_that_needs_not_decide_leaves_estimates_as_they_are(monkeypatch):
    flat = project(*sheet(lambda x, y: 0.0)).run(("feasibility", "trial layout"))
    assert flat["trial layout"] == trial_layout.TrialLayout(())
    monkeypatch.setattr(trial_layout, "MOST_TILES", 10)
    many = project(*tip(), remesh=False).run(("trial layout",))
    assert not many["trial layout"].shown and many["trial layout"].blocked == many["feasibility"].blocked
    monkeypatch.undo()
    off = project(*tip(), remesh=False, run_verification=False).run(("trial layout",))
    assert not off["trial layout"].shown and off["trial layout"].blocked == off["feasibility"].blocked
    monkeypatch.setattr(trial_layout, "REPAIR_STEPS", 0)
    ended = project(*cone(1.1)).run(("trial layout",))
    assert ended["trial layout"].shown == "undecided"
    assert ended["trial layout"].blocked == ended["feasibility"].blocked
    with pytest.raises(Stopped):
        project(*tip(), remesh=False).run(("trial layout",),
                                          Job(lambda what, fraction: "membrane" not in what))


def test_bad_input_leaves_nothing(curveups, tmp_path):
    ran = curveups("check", tmp_path / "none.obj", "-o", tmp_path / "out")
    assert ran.status == 2 and len(ran.error_lines) == 1 and not (tmp_path / "out").exists()
    assert ran.out == ""


def test_a_closed_target_is_told_to_be_cut():
    V, F = native.builtin_target("half-sphere", 0.5)
    V = V - [0, 0, V[:, 2].min()]
    mirrored = np.arange(len(V)) + np.where(V[:, 2] < 1e-9, 0, len(V))
    F = np.vstack([F, mirrored[F][:, ::-1]]).astype(np.int32)
    closed = project(np.vstack([V, V * [1, 1, -1]]), F, L=9.0).run(("feasibility",))["feasibility"]
    assert {one.obstacle for one in closed.blocked} == {"closed"}
    assert {one.tile for one in closed.blocked} == set(range(len(closed.F)))


def test_parts_that_run_into_one_another_are_named():
    V, F = sheet(lambda x, y: 0.0, 14, 4)
    both = np.vstack([V, V - [0, 0, 1.0]])
    found = examine(both, np.vstack([F, F + len(V)]).astype(np.int32), NO_CUTS, native.Parameters(), Job())
    assert found.overlapping.size and not found.feasible
    named = {one.tile for one in found.blocked if one.obstacle == "overlap" and one.certain}
    assert named == set(found.overlapping.ravel().tolist())


def storeys(apart):
    V, F = sheet(lambda x, y: 0.0, 14, 4)
    return np.vstack([V, V + [0, 0, apart]]), np.vstack([F, F + len(V)]).astype(np.int32)


def test_pins_between_parts_that_face_one_another_need_room():
    """A storey as high as a body and the pins of both."""
    def found(apart, **values):
        parameters = native.Parameters()
        for name, value in values.items():
            parameters.set(name, value)
        return examine(*storeys(apart), NO_CUTS, parameters, Job())

    assert found(5.01).feasible
    low = found(4.9)
    assert low.possible and not low.feasible and not low.overlapping.size
    assert {one.obstacle for one in low.blocked} == {"overlap"} and low.blocked[0].why.kind == "overlap.pins"
    assert {one.tile for one in low.blocked} == set(low.meeting.ravel().tolist()) == set(range(len(low.F)))
    assert found(4.9, H_pin=0.94).feasible and found(4.9, H_body=2.89).feasible
    # Tiles by which a design is held are no tiles of what is tried.
    parameters = native.Parameters()
    parameters.set("held_tiles", "T09999")
    assert native.facing_pins(*storeys(5.01), NO_CUTS, parameters) == []


def test_the_terminal_says_why_tiles_can_not_be_made():
    results = project(*storeys(1.0), remesh=False).run(asked_by("check"))
    lines = check.table(results)
    place = next(k for k, line in enumerate(lines) if line.startswith("64 of 64 tiles can't be made"))
    assert lines[place + 1] == ("  T00001: it runs through T00033, another part of the target, and no plane "
                                "parts them (64 tiles)")
    assert not lines[place + 2].startswith(" ")
    # Estimates come last and have the mark that is explained above.
    cuts = Finding.about("membrane.cuts", [4], side="front", tile=(4,), depth=0.2)
    blocked = (Obstacle(cuts, certain=False), results["trial layout"].blocked[0])
    found = check._reasons({"trial layout": trial_layout.TrialLayout(blocked)})
    assert found == [f"T00001: {blocked[1].why}", f"T00005: {cuts} *"]


def test_thinner_tiles_with_lower_pins_do_where_neither_does_alone(curveups, tmp_path):
    """Two strips across one another, 2.2 to 4 mm apart."""
    def strip(turned):
        def at(u, v):
            x, y = 80 * u - 40, 24 * v - 12
            return (-y, x, 4 - 0.004 * x * x) if turned else (x, y, 0.004 * x * x)
        columns, rows = 24, 8
        points = [at(i / columns, j / rows) for j in range(rows + 1) for i in range(columns + 1)]
        faces = []
        for j in range(rows):
            for i in range(columns):
                a = j * (columns + 1) + i
                faces += [(a, a + 1, a + columns + 2), (a, a + columns + 2, a + columns + 1)]
        return points, faces

    (V, F), (W, G) = strip(False), strip(True)
    both = np.array(V + W, float), np.array(F + [[i + len(V) for i in face] for face in G], np.int32)
    path = tmp_path / "strips.obj"
    path.write_text(obj_text(*both))
    sizes = project(*both).run(("sizes",))["sizes"]
    assert not sizes.as_set and sizes.L is None and sizes.H_pin is None
    H_body, H_pin = sizes.together
    assert 0.5 < H_pin < 0.6 * H_body < 1.5
    assert not project(*both, H_body=H_body).run(("feasibility",))["feasibility"].feasible
    ran = curveups("check", path, "-o", tmp_path / "check")
    assert ran.status == 1 and f"H_body = {H_body:g} mm and H_pin = {H_pin:g} mm together do" in ran.out
    told = json.loads((tmp_path / "check" / "check.json").read_text("utf-8"))
    assert told["recommended"]["together"] == {"H_body": H_body, "H_pin": H_pin} and told["pins_meeting"]
    advised = f"H_body={H_body:g} with H_pin={H_pin:g}"
    ran = curveups("design", path, "-o", tmp_path / "as-set", "--no-solids")
    assert ran.status == 2 and advised in ran.error_lines[0]
    ran = curveups("design", path, "-o", tmp_path / "advised", "--no-solids", "--set",
                   *advised.split(" with "))
    assert ran.status == 0, ran.err


@pytest.mark.parametrize("height", [lambda x, y: 14 * math.exp(-(x * x + y * y) / 120),
                                    lambda x, y: -0.75 * abs(x)])
def test_recommended_sizes_do_and_those_beyond_do_not(height):
    V, F = sheet(height, 25, 40)
    results = project(V, F).run(("feasibility", "sizes"))
    found = results["sizes"]
    told = {(L, H_body): feasible for L, H_body, H_pin, _, feasible in found.tried if H_pin == 1}
    trial = results["trial layout"]
    assert told[7.0, 3.0] == found.as_set == trial.feasible
    if found.L is not None:
        low, high = found.L
        for end in found.L:
            again = project(V, F, L=end).run(("feasibility",))["feasibility"]
            assert again.feasible and told[end, 3.0]
        inside = [feasible for (L, H_body), feasible in told.items() if H_body == 3 and low <= L <= high]
        assert all(inside)
    if found.H_body is not None:
        assert project(V, F, H_body=found.H_body).run(("feasibility",))["feasibility"].feasible
    assert found.L is not None or found.H_body is not None or not any(told.values())
    pins = {H_pin: feasible for L, H_body, H_pin, _, feasible in found.tried if (L, H_body) == (7.0, 3.0)}
    assert len(pins) > 3 and found.H_pin is not None and pins[found.H_pin]
    assert (found.H_pin <= 1) == found.as_set
    lower = max(height for height in pins if height < found.H_pin)
    assert not pins[lower] and lower > 0.9 * found.H_pin
    named = project(V, F, H_pin=found.H_pin).run(("trial layout",))
    assert named["feasibility"].feasible if found.as_set else named["trial layout"].feasible
    below = project(V, F, H_pin=lower).run(("feasibility",))["feasibility"]
    if found.as_set:
        assert not below.feasible
    else:  # the bar that trials have raised lies between
        assert (below.membrane_clearance.min() / lower
                < named["feasibility"].membrane_clearance.min() / found.H_pin)


@pytest.mark.parametrize("rise, size, parts", [(0.75, 20, 40), (1.3, 12, 12)])
def test_sizes_out_of_reach_are_known_without_moving_vertices(monkeypatch, rise, size, parts):
    """The sizes are those of a search that moves vertices for each, with fewer moves."""
    counts = []

    def tried():
        counts.append(0)
        return project(*sheet(lambda x, y: -rise * abs(x), size, parts)).run(("sizes",))["sizes"].tried

    def smooth(*given):
        counts[-1] += 1
        return pin_smoothing.smooth_for_pins(*given)

    monkeypatch.setattr(feasibility, "smooth_for_pins", smooth)
    found = tried()
    monkeypatch.setattr(feasibility, "MOST_SMALL", 1.0)
    monkeypatch.setattr(feasibility, "MOST_CLEARED", np.inf)
    assert tried() == found and counts[0] < counts[1]


def test_errors_of_design_say_which_size_would_do_by_estimates():
    V, F = sheet(lambda x, y: -0.75 * abs(x), 20, 20)
    with pytest.raises(CurveUpsError) as told:
        project(V, F, H_body=8).run(("layout",))
    assert "'curveups check' makes trial layouts" in told.value.remedy
    words = told.value.remedy.split("were tried, ")[1].split(" does by estimates")[0].split(" or ")
    assert len(words) == 2
    for word in words:
        name, _, value = word.partition("=")
        values = {"H_body": 8.0, name: float(value)}
        assert project(V, F, **values).run(("feasibility",))["feasibility"].feasible


def test_a_design_that_is_not_valid_names_the_sizes_that_check_does(curveups, tmp_path):
    """A trough that is bent so narrowly that pins inside of it have too little room."""
    def point(u, v):
        straight, radius = 12.0, 5.6
        s = u * (2 * straight + math.pi * radius) - straight
        angle = min(max(s / radius, 0.0), math.pi)
        along = min(s, 0.0) + max(s - math.pi * radius, 0.0)
        return along * math.cos(angle) + radius * math.sin(angle), 16 * v, radius * math.cos(angle)

    V = np.array([point(i / 80, j / 16) for i in range(81) for j in range(17)])
    F = [(a, a + 17, a + 18) for a in range(80 * 17) if a % 17 < 16]
    F += [(a, a + 18, a + 1) for a in range(80 * 17) if a % 17 < 16]
    path = tmp_path / "trough.obj"
    path.write_text(obj_text(V, F))
    assert curveups("check", path, "-o", tmp_path / "check").status == 1
    most = json.loads((tmp_path / "check" / "check.json").read_text("utf-8"))["recommended"]["H_body"]
    assert 0.5 < most < 3
    sound = curveups("design", path, "-o", tmp_path / "sound", "--no-solids", "--set", f"H_body={most}")
    assert sound.status == 0, sound.err
    assert curveups("design", path, "-o", tmp_path, "--no-solids", "--set", "run_repair=off").status == 1
    reasons = json.loads((tmp_path / "report.json").read_text("utf-8"))["reasons"]
    said, = (one for one in reasons if "estimates of 'curveups check' find nothing in the way" in one)
    name, _, value = said.removeprefix("suggested: ").split(",")[0].split(" or ")[0].partition("=")
    assert name == "H_body" and most <= float(value) < 3  # by estimates: no trial is made there
    assert curveups("check", path, "--set", f"H_body={value}").status == 0


def test_a_design_whose_parts_meet_names_the_sizes_that_check_does(curveups, tmp_path):
    """Two sheets of a dome above one another: all contacts push, and pins between the sheets meet."""
    V, F = sheet(lambda x, y: math.sqrt(3600 - x * x - y * y), 25, 20)
    path = tmp_path / "domes.obj"
    path.write_text(obj(np.vstack([V, V + [0, 0, 4.6]]), np.vstack([F, F + len(V)])))
    ran = curveups("design", path, "-o", tmp_path, "--no-solids", "--set", "L=9", "settle=off")
    assert ran.status == 1, ran.err
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert report["unilateral"]["feasible"] and report["contact_forces"]["points_below_f_min"] == 0
    first, advised = report["reasons"]
    assert "overlap" in first and "find nothing in the way" in advised, report["reasons"]
    size, _, _ = advised.removeprefix("suggested: ").partition(" or ")
    name, _, value = size.partition("=")
    assert name == "H_body" and 1 < float(value) < 3, advised
    assert size in (tmp_path / "report.html").read_text(encoding="utf-8")
    ran = curveups("design", path, "-o", tmp_path / "advised", "--no-solids", "--set", "L=9", "settle=off",
                   size)
    assert ran.status == 0, ran.err


def test_errors_of_design_with_mending_say_which_size_would_do_without():
    V, F = sheet(lambda x, y: -3.5 * abs(x), 8, 8)
    with pytest.raises(CurveUpsError) as told:
        project(V, F, H_body=8, mend="on", mend_max=0.1).run(("layout",))
    assert told.value.remedy.endswith("H_body=auto and L=auto try them with mending, too"), told.value.remedy


def test_series_are_round_and_ascending():
    values = size_search.series(0.2, 14)
    assert values == sorted(set(values)) and values[0] >= 0.2 and values[-1] == 14
    assert all(len(f"{value:g}".replace(".", "").lstrip("0")) <= 2 for value in values)
    assert all(b / a < 1.2 for a, b in zip(values, values[1:]))


def test_a_check_can_be_stopped():
    seen = []

    def go_on(what, fraction):
        seen.append(what)
        return not what.startswith("trying")

    from curveups.base.errors import Stopped

    V, F = sheet(lambda x, y: 0.0, 20, 10)
    with pytest.raises(Stopped):
        project(V, F).run(("sizes",), Job(go_on))
    assert sum(what.startswith("trying") for what in seen) == 1


def test_thinner_tiles_under_higher_pins_are_named_where_neither_does_alone(tmp_path):
    """A bent strip with tiles as thick as three quarters of their length: membranes cut into them."""
    found = held_out.judge_named(244, tmp_path)
    assert found["as_set"] is False and list(found["named"]) == ["together"]
    named = found["named"]["together"]
    assert named["H_body"] < found["H_body"] and named["H_pin"] > found["H_pin"]
    assert named["design"] is True, named
