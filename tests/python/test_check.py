# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups check`: what of a target can be tiles, and limits of sizes by estimates."""

import json
import math

import cad
import numpy as np
import pytest
from curveups.base.errors import CurveUpsError
from curveups.base.findings import Finding
from curveups.base.native import native
from curveups.base.parameters import with_values
from curveups.report import check
from curveups.stages import stages_of
from curveups.stages.feasibility import (Obstacle, TileFigure, examine, least_radius,
                                         sharpest_fold, too_stretched)
from curveups.stages.sizes import limit, unhindered
from curveups.stages.stage import Job
from made import project, sheet
from shapes import obj_text

NO_CUTS = np.zeros((0, 2), np.int32)
LIMITS = stages_of("check", "sizes")


def cone(slope):
    return sheet(lambda x, y: -slope * math.hypot(x, y))


def storeys(apart):
    """Two flat sheets, one above the other."""
    V, F = sheet(lambda x, y: 0.0, 14, 4)
    return np.vstack([V, V + [0, 0, apart]]), np.vstack([F, F + len(V)]).astype(np.int32)


def test_a_filleted_lid_is_checked_without_a_warning(curveups_process, tmp_path):
    """Membranes would cut into tiles at its fillets; numpy warned of what has no value."""
    lid = cad.make(tmp_path, "lid")["lid"]
    ran = curveups_process("check", lid, "--set", "L=16", PYTHONWARNINGS="error")
    assert ran.status == 1 and ran.out.startswith("lid: "), (ran.out, ran.err)
    assert "tiles are likely to fail" in ran.out and "(at L 16 mm)" in ran.out, ran.out
    said = ran.err.splitlines()
    assert all(line.startswith("curveups: ") for line in said), ran.err
    tried = [line for line in said if "trying L = " in line]
    assert len(tried) == len(set(tried)) >= 1, ran.err


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
    most = found["recommended"]["H_body"]
    assert most >= 3 and f"H_body can be up to {most:g} mm (at L" in ran.out
    assert "\nall tiles can be made\n" in ran.out and "L can be" not in ran.out
    page = (tmp_path / "out" / "check.html").read_text(encoding="utf-8")
    assert "Feasible" in page and "data:image/png;base64," in page
    assert not (tmp_path / "out" / "design.json").exists()
    assert curveups("check", cap, "--no-remesh").out == ran.out  # nothing needs a folder


def test_a_tip_is_named_and_a_higher_pin_clears_it(curveups, tmp_path):
    path = tmp_path / "cone.obj"
    path.write_text(obj_text(*cone(1.1)))
    ran = curveups("check", path, "-o", tmp_path)
    assert ran.status == 1, ran.err
    found = json.loads((tmp_path / "check.json").read_text("utf-8"))
    assert not found["feasible"] and {one["obstacle"] for one in found["blocked"]} == {"membrane"}
    assert not any(one["certain"] for one in found["blocked"])
    first = found["blocked"][0]
    assert f"\n  T{first['tile'] + 1:05d}: {first['why']} *" in ran.out
    remeshed = project(*cone(1.1)).run(("target",))["target"]
    from_tip = np.linalg.norm(remeshed.V, axis=1)[remeshed.F].min(axis=1)
    assert all(from_tip[one["tile"]] < 7 for one in found["blocked"])
    # A membrane may not pass above a tile by less than it sags.
    rooms = [min(tile["membrane_room_mm"]) for tile in found["tiles"]]
    assert any(0 < room < 0.3 for room in rooms)
    assert {one["tile"] for one in found["blocked"]} == {k for k, room in enumerate(rooms) if room < 0.3}
    assert curveups("check", path, "--set", "H_pin=2").status == 0


def roof(radius, angle):
    """Two planes with a fold between them; its arc turns by this angle (degrees)."""
    half = math.radians(angle) / 2
    reach = radius * math.sin(half)

    def height(x, y):
        if abs(x) < reach:
            return math.sqrt(radius ** 2 - x * x)
        return radius * math.cos(half) - (abs(x) - reach) * math.tan(half)

    return sheet(height, parts=120)


def test_the_sharpest_fold_is_named_with_the_radius_that_does():
    at = project(*roof(3.0, 110), L=7.0).run(("feasibility",))["feasibility"]
    sharp = at.sharpest
    assert sharp.kind == "sharp" and sharp.tiles[0] in {one.tile for one in at.blocked}
    assert np.abs(at.V[at.F[sharp.tiles[0]]].mean(axis=0)[0]) < 7  # beside the fold, along y
    assert 2 < sharp.figures["radius"] < 4.5
    assert str(sharp) == (f"fold of {sharp.figures['radius']:.2g} mm radius at T{sharp.tiles[0] + 1:05d}: "
                          f"{sharp.figures['least']:.2g} mm would do at L 7 mm, H_body 3 mm")
    least = sharp.figures["least"]
    assert least == least_radius(with_values(native.Parameters(), {"L": 7.0}))
    around = project(*roof(1.1 * least, 110), L=7.0).run(("feasibility",))["feasibility"]
    assert around.feasible and around.sharpest is None


def test_thick_tiles_ask_for_blunt_folds_and_small_ones_have_no_room_for_pins():
    def least(**values):
        return least_radius(with_values(native.Parameters(), values))

    assert 3 < least(L=9.0, H_body=3.0) < least(L=9.0, H_body=6.0) < 12
    flat = project(*sheet(lambda x, y: 0.0, 10, 4), L=2.6, H_body=0.4).run(("feasibility",))["feasibility"]
    assert flat.sharpest.kind == "sharp.flat" and "even where it is flat" in str(flat.sharpest)


def test_narrow_tiles_are_no_folds():
    V, F = sheet(lambda x, y: 0.0, 14, 4)
    V[:, 1] *= 0.2
    narrow = project(V, F, remesh=False).run(("feasibility",))["feasibility"]
    assert {one.obstacle for one in narrow.blocked} >= {"pin"} and narrow.sharpest is None
    alone = examine(V[F[0]] * [1, 0.2, 1], np.array([[0, 1, 2]], np.int32), NO_CUTS, native.Parameters())
    assert {one.obstacle for one in alone.blocked} >= {"pin"}
    assert sharpest_fold(alone, native.Parameters()) is None


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
    assert {one.tile for one in closed.blocked} == set(range(len(closed.F))) and unhindered(closed)


def test_parts_that_run_into_one_another_are_named():
    V, F = sheet(lambda x, y: 0.0, 14, 4)
    both = np.vstack([V, V - [0, 0, 1.0]])
    found = examine(both, np.vstack([F, F + len(V)]).astype(np.int32), NO_CUTS, native.Parameters())
    pairs = {(obstacle.tile, *obstacle.why.figures["other"]) for obstacle in found.blocked
             if obstacle.obstacle == "overlap" and obstacle.certain}
    assert pairs and not found.feasible
    assert all((tile < len(F)) != (other < len(F)) and (other, tile) in pairs for tile, other in pairs)


def test_pins_between_parts_that_face_one_another_need_room():
    """A storey as high as a body and the pins of both."""
    def found(apart, **values):
        return examine(*storeys(apart), NO_CUTS, with_values(native.Parameters(), values))

    assert found(5.01).feasible
    low = found(4.9)
    assert not any(one.certain for one in low.blocked) and not low.feasible
    assert {one.obstacle for one in low.blocked} == {"overlap"} and low.blocked[0].why.kind == "overlap.pins"
    assert {one.tile for one in low.blocked} == set(range(len(low.F)))
    assert found(4.9, H_pin=0.94).feasible and found(4.9, H_body=2.89).feasible
    # Tiles by which a design is held are no tiles of what is tried.
    parameters = native.Parameters()
    parameters.set("held_tiles", "T09999")
    assert native.facing_pins(*storeys(5.01), NO_CUTS, parameters) == []


def test_the_terminal_says_why_tiles_can_not_be_made():
    results = project(*storeys(1.0), remesh=False).run(stages_of("check"))
    lines = check.table(results)
    place = next(k for k, line in enumerate(lines) if line.startswith("64 of 64 tiles can't be made"))
    assert lines[place + 1:] == ["  T00001: it runs through T00033, another part of the target, and no plane "
                                 "parts them (64 tiles)"]
    # Estimates come last and have the mark that is explained above.
    cuts = Finding.about("membrane.cuts", [4], side="front", tile=(4,), depth=0.2)
    blocked = (Obstacle(cuts, certain=False), results["feasibility"].blocked[0])
    assert check._reasons(blocked) == [f"T00001: {blocked[1].why}", f"T00005: {cuts} *"]


def test_a_figure_names_its_worst_tile_and_counts_those_that_miss_it():
    values = np.array([3.0, np.nan, 1.0, 2.0])
    blocked = tuple(Obstacle(Finding.about("pin", [tile], side=side))
                    for tile, side in ((1, "back"), (2, "back"), (2, "front"), (2, "front")))
    figure = TileFigure("area", values, 2.0, "pin", "back")
    assert figure.worst() == 2 and figure.short(blocked) == 2
    assert TileFigure("area", values, 2.0, "pin", most=True).worst() == 0
    assert TileFigure("area", values, 2.0, "pin", "front").short(blocked) == 1
    assert TileFigure("area", values, 2.0, "fold").short(blocked) == 0
    assert TileFigure("area", np.full(3, np.nan), 2.0, "pin").worst() is None


def test_stretch_is_in_the_way_where_some_tiles_are_slack_and_others_narrow():
    """Factors and shares are those at which designs began to fail."""
    stretch, ranges = np.ones(100), np.tile([0.5, 2.0], (100, 1))
    stretch[:6], stretch[6:12] = 2.41, 0.349
    assert np.flatnonzero(too_stretched(stretch, ranges)).tolist() == list(range(12))
    for slack, narrow, count in ((2.39, 0.349, 6), (2.41, 0.351, 6), (2.41, 0.349, 5)):
        stretch[:] = 1.0
        stretch[:count], stretch[6:6 + count] = slack, narrow
        assert not too_stretched(stretch, ranges).any()


@pytest.mark.parametrize("height, H_body, as_set", [
    (lambda x, y: 6 * math.exp(-(x * x + y * y) / 240), 3.0, True),
    (lambda x, y: -0.75 * abs(x), 5.0, False)])
def test_sizes_within_limits_do_and_those_beyond_do_not(height, H_body, as_set):
    V, F = sheet(height, 25, 40)
    results = project(V, F, H_body=H_body).run(LIMITS)
    found = results["sizes"]
    assert results["feasibility"].feasible == as_set

    def works(**values):
        made = project(V, F, **{"H_body": H_body, **values}).run(("target",))
        return examine(made["target"].V, made["target"].F, NO_CUTS, made.parameters).feasible

    low, high = found.L
    assert works(L=low) and works(L=high) and low <= high
    assert (low <= 7 <= high) == as_set
    below = low - 10 ** (math.floor(math.log10(0.999 * low)) - 1)  # the next value of two digits
    assert below < 7 / 2.5 or not works(L=below)
    assert works(H_body=found.H_body) and (found.H_body >= H_body) == as_set
    assert not works(H_body=1.06 * found.H_body)
    said = [str(one) for one in check.advice(results)]
    assert said[:2] == [f"L can be {low:g} mm to {high:g} mm (at H_body {H_body:g} mm)",
                        f"H_body can be up to {found.H_body:g} mm (at L 7 mm)"]


def test_no_limit_is_named_where_no_size_was_found():
    results = project(*storeys(1.0)).run(LIMITS)
    assert results["sizes"].L is None and results["sizes"].H_body is None
    said = [str(one) for one in check.advice(results)]
    assert said[0].startswith("no L was found") and said[1].startswith("no H_body was found")


def test_a_limit_is_found_among_round_values():
    tried = []

    def works(value):
        tried.append(value)
        return 2.0 <= value <= 5.03

    assert limit(3.21, 30.0, works) == 5.0 and limit(3.21, 1.0, works) == 2.0
    assert all(float(f"{value:.2g}") == value for value in tried) and len(tried) < 16
    assert limit(3.21, 5.02, works) == 5.02 and limit(3.21, 3.21, works) == 3.21


def test_a_refused_design_says_what_is_in_the_way_and_forecasts_nothing():
    V, F = sheet(lambda x, y: -0.75 * abs(x), 20, 20)
    with pytest.raises(CurveUpsError) as told:
        project(V, F, H_body=8).run(("layout",))
    assert told.value.finding.kind == "sharp_fold" and told.value.tiles
    assert "tried" not in str(told.value) and "does" not in told.value.remedy


def test_a_check_that_is_stopped_keeps_its_margins():
    seen = []

    def go_on(what, fraction):
        seen.append(what)
        return not what.startswith("trying")

    V, F = sheet(lambda x, y: 0.0, 20, 10)
    results = project(V, F).run(LIMITS, Job(go_on))
    assert results.stopped and results["feasibility"].feasible
    assert sum(what.startswith("trying") for what in seen) == 1
    assert check.build_check(results)["recommended"] == {"L": None, "H_body": None}
    assert check.advice(results) == []
