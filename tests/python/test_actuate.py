# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups actuate`: the answers, the path and the files that others read."""

import dataclasses
import json
import os
import re
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from schema import OPTIONAL, check

from curveups.base.errors import CurveUpsError, Stopped
from curveups.base.native import native
from curveups.kit.former import Former
from curveups.project import saved_results
from curveups.project.project import Project
from curveups.report import actuation
from curveups.report.exports import report
from curveups.report.moving import front_corners, moving_view, tile_marks
from curveups.stages import HELP, RISEN, START, actuation_help, asked_by
from curveups.stages.actuation import ActuationStart, findings, tiles_digest
from curveups.stages.actuation_help import ActuationHelp, Change, Trial
from curveups.stages.sheets import sheets
from curveups.stages.stage import Job

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))
import actuated  # noqa: E402

FILES = {"frames.json", "frames.fold", "actuation.html", "small-cap-settled.step", "small-cap-former.stl"}


@pytest.fixture(scope="module")
def risen(curveups, printed, tmp_path_factory):
    folder = tmp_path_factory.mktemp("risen")
    source = printed.folder / "design.json"
    ran = curveups("actuate", source, "-o", folder, "--set", "bumps=none", "friction_coefficient=0.6")
    read = {name: json.loads((folder / name).read_text("utf-8"))
            for name in ("actuation.json", "frames.json", "frames.fold")}
    design = native.read_design(source.read_text("utf-8"))
    return SimpleNamespace(folder=folder, ran=ran, source=source, design=design,
                           answer=read["actuation.json"], frames=read["frames.json"]["frames"],
                           fold=read["frames.fold"])


def test_the_answer_and_its_status_agree(risen):
    block = risen.answer["actuation"]
    assert risen.answer["format"] == "curveups-actuation" and risen.answer["status"] == "complete"
    assert risen.answer["from"] == "flat" and risen.answer["tiles"] == 24
    assert block["converged"] and risen.ran.status == (0 if block["arrives"] else 1)
    assert block["arrives"] == (block["shortfall_mm"] <= block["tolerance_mm"] and not block["open_contacts"])
    friction = [one["friction_coefficient"] for one in block["sampled"]]
    assert friction[0] == 0 and friction[-1] == 0.6 and friction == sorted(friction)
    reached = [one["friction_coefficient"] for one in block["sampled"] if one["arrives"]]
    assert block["reach_friction"] == (max(reached) if reached else None)
    assert block["scan_frictionless"] == block["sampled"][0]["scan"]
    assert block["from_target"]["converged"] and not block["from_target"]["open_contacts"]


def test_what_it_finds_is_said_with_its_tiles(risen):
    said = [str(one) for one in findings(risen.answer["actuation"])]
    assert said and [one["what"] for one in risen.answer["findings"]] == said
    assert all(f"small-cap: {one}" in risen.ran.err for one in said)
    assert said[-1] == str(findings(risen.answer["actuation"])[-1]) and "taps" in said[-1]
    tiles = {tile for pair in risen.answer["actuation"]["open_contacts"] for tile in pair}
    assert set(risen.answer["findings"][0]["tiles"]) == tiles


def block_of(**changed):
    end = {"wedged": [[1, 4], [2, 6]], "friction_coefficient": 0}
    return {"arrives": False, "stopped": False, "shortfall_mm": 2.5, "tolerance_mm": 0.07, "contacts": 9,
            "open_contacts": [[0, 1], [3, 5]], "trap": False, "trap_distance_mm": 1.25,
            "reach_friction": None, "sampled": [end], **changed}


@pytest.mark.parametrize("changed, kinds", [
    ({"arrives": True, "open_contacts": []}, ["actuation_arrives"]),
    ({}, ["actuation_jammed"]),
    ({"open_contacts": []}, ["actuation_short"]),
    ({"trap": True}, ["actuation_jammed", "actuation_trapped"]),
    ({"trap": True, "sampled": [{"wedged": []}]}, ["actuation_jammed", "actuation_elsewhere"]),
    ({"reach_friction": 0.1}, ["actuation_jammed", "actuation_friction"]),
    ({"contacts_anew": True}, ["actuation_jammed", "actuation_anew"]),
    ({"arrives": None, "trap": None}, ["actuation_restless"]),
    ({"arrives": None, "stopped": True}, ["actuation_stopped"])])
def test_each_answer_has_its_words(changed, kinds):
    found = findings(block_of(**changed))
    assert [one.kind for one in found] == kinds
    for one in found:
        assert str(one) != one.kind and "{" not in str(one)
    if kinds[0] == "actuation_jammed":
        assert found[0].tiles == (0, 1, 3, 5) and "2.5 mm" in str(found[0]) and "2 of 9" in str(found[0])
        assert "T00001-T00002" in str(found[0]) and found[0].remedy()
    if kinds[-1] == "actuation_trapped":
        assert found[-1].tiles == (1, 2, 4, 6) and "T00002-T00005" in str(found[-1])


def by_hand(tiles=(), reached="home", tried=0, ways=("inwards",), converged=True):
    hands = [{"tiles": list(tiles[k::len(ways)]), "way": way, "force_n": 2.0, "direction": [0, 0, -1]}
             for k, way in enumerate(ways) if tiles[k::len(ways)]]
    end, shaken = ({"shortfall_mm": far, "open_contacts": [[0, 1]], "converged": converged}
                   for far in (0.05, 1.5))
    return {"hands": hands, "by_hand": {"taps": 7, "tried": tried, "reached": reached, "end": end,
                                        "shaken": shaken, "largest_force_n": 8.0}}


@pytest.mark.parametrize("given, kind, words", [
    (by_hand(), "hands_shaken", ["7 taps", "1.5 mm"]),
    (by_hand((3, 8, 9), tried=4, ways=("inwards", "outwards")), "hands_press",
     ["press T00004, T00010 inwards, T00009 outwards", "2 N a tile", "0.05 mm", "1 of 9"]),
    (by_hand(range(30), tried=5, ways=["sideways"] * 10), "hands_over", ["30 tiles", "former", "2 N"]),
    (by_hand(reached="none", tried=3), "hands_none", ["of 3", "up to 8 N", "0.05 mm short"]),
    (by_hand((3, 8), reached="none", tried=1), "hands_short",
     ["2 tiles", "2 N a tile", "0.05 mm short", "1 of 9"]),
    (by_hand((3, 8), reached="none", tried=1, converged=False), "hands_restless", ["do not come to rest"]),
    (by_hand(reached="shape", tried=3), "hands_no_more", ["1.5 mm", "none of 3 touches"])])
def test_what_hands_do_has_its_words(given, kind, words):
    found = findings(block_of(**given))
    assert [one.kind for one in found] == ["actuation_jammed", kind]
    assert all(word in str(found[-1]) for word in words), str(found[-1])
    assert set(found[-1].tiles) == {tile for touch in given["hands"] for tile in touch["tiles"]}
    assert findings(block_of(**given, arrives=None, trap=None))[-1].kind == "actuation_restless"
    assert findings(block_of(stopped=True))[-1].kind == "hands_stopped"


def test_hands_go_on_where_the_path_ends(risen):
    block = risen.answer["actuation"]
    hands = json.loads((risen.folder / "frames.json").read_text("utf-8"))["hands"]
    assert not block["arrives"] and len(hands) > 3
    steps = [risen.frames[-1], *hands]
    for name in ("time", "friction"):
        assert (np.diff([frame[name] for frame in steps]) >= 0).all()
    assert hands[block["by_hand"]["shaken_frame"]]["energy"] == pytest.approx(
        block["by_hand"]["shaken"]["energy_n_mm"])
    assert block["by_hand"]["shaken"]["energy_n_mm"] < risen.frames[-1]["energy"]
    touched = [tile for touch in block["hands"] for tile in touch["tiles"]]
    assert len(touched) == len(set(touched)) and all(0 <= tile < 24 for tile in touched)
    assert (block["by_hand"]["reached"] == "none") <= (block["hands"] == [])


def test_chosen_tiles_are_pressed_and_the_answer_says_how_far_that_leads(risen, curveups, tmp_path):
    ran = curveups("actuate", risen.source, "-o", tmp_path, "--press", "T00007, T00003", "--force", "1.5",
                   "--set", "bumps=none", "friction_coefficient=0.6", "hold_tolerance=0.01")
    answer, frames = (json.loads((tmp_path / name).read_text("utf-8"))
                      for name in ("actuation.json", "frames.json"))
    block, found = answer["actuation"], answer["actuation"]["by_hand"]
    assert ran.status == 1 and found["tried"] == 1 and found["largest_force_n"] == 1.5
    assert sorted(tile for touch in block["hands"] for tile in touch["tiles"]) == [2, 6]
    assert {touch["force_n"] for touch in block["hands"]} == {1.5}
    end = found["end"]
    home = end["converged"] and end["shortfall_mm"] <= 0.01
    assert found["reached"] == ("none" if not home else "shape" if end["open_contacts"] else "home")
    pressed = frames["hands"][found["shaken_frame"] + 1:]
    assert pressed and pressed[-1]["energy"] == pytest.approx(end["energy_n_mm"])
    assert any(frame["work"] for frame in pressed)
    assert answer["findings"][-1]["tiles"] == [2, 6] and answer["findings"][-1]["what"] in ran.err
    assert "T00003" in (tmp_path / "actuation.html").read_text("utf-8")


def test_tiles_that_were_chosen_in_another_design_are_not_pressed(risen):
    parameters = native.Parameters(risen.design.parameters)
    for name, value in {"bumps": "none", "friction_coefficient": 0.6, "hold_tolerance": 0.01}.items():
        parameters.set(name, value)
    project = Project.of_design(risen.design.with_parameters(parameters))
    project.give(START, ActuationStart(hands=True, press=(3,), of="another"))
    block = project.run((RISEN,))[RISEN].block
    assert block["by_hand"]["tried"] > 1
    project.give(START, ActuationStart(hands=True, press=(3,), of=tiles_digest(risen.design)))
    block = project.run((RISEN,))[RISEN].block
    assert block["by_hand"]["tried"] == 1 and [touch["tiles"] for touch in block["hands"]] == [[3]]


@pytest.mark.parametrize("options, words", [
    (("--press", "T00099"), ["'T00099' is no tile", "give some of T00001 to T00024"]),
    (("--press", "7"), ["'7' is no tile"]),
    (("--press", ""), ["'' is no tile", "give some of"]),
    (("--press", "T00002,T00005,T00002"), ["twice", "T00002", "name it once"]),
    (("--press", "T00002", "--force", "0"), ["--force", "0 N", "above 0 N"]),
    (("--press", "T00002", "--force", "-2"), ["--force", "-2 N", "above 0 N"]),
    (("--press", "T00002", "--force", "nan"), ["--force", "nan N", "above 0 N"]),
    (("--press", "T00002", "--force", "inf"), ["--force", "inf N", "above 0 N"]),
    (("--press", "T00002", "--force", "much"), ["--force", "much"]),
    (("--force", "2"), ["no tile to press", "--press"]),
    (("--press", "T00002", "--no-hands"), ["leave --no-hands out"]),
    (("--press", "T00002", "--from", "target"), ["leave --from out"])])
def test_what_can_not_be_pressed_is_refused(risen, curveups, tmp_path, options, words):
    ran = curveups("actuate", risen.source, "-o", tmp_path / "out", *options)
    assert ran.status == 2 and not (tmp_path / "out").exists()
    assert all(word in ran.err.splitlines()[-1] for word in words), ran.err


def test_the_former_is_that_of_the_kit(risen):
    data = (risen.folder / "small-cap-former.stl").read_bytes()
    corners = np.frombuffer(data[84:], np.dtype([("n", "<f4", 3), ("at", "<f4", (3, 3)), ("x", "<u2")]))["at"]
    parts = native.evaluate_design(risen.design)
    area = {"flat_cm2": parts.flat_area_mm2 / 100, "actuated_cm2": parts.actuated_area_mm2 / 100}
    expected = Former.of(risen.design, risen.design.parameters, area)
    volume = np.einsum("nk,nk->n", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
    assert volume == pytest.approx(1000 * sum(one.volume for one in expected), rel=0.01)


def test_without_hands_nothing_is_said_of_them(risen, curveups, tmp_path):
    curveups("actuate", risen.source, "-o", tmp_path, "--no-hands", "--set", "bumps=none",
             "friction_coefficient=0.6")
    answer = json.loads((tmp_path / "actuation.json").read_text("utf-8"))
    assert "hands" not in answer["actuation"] and "hands" not in json.loads(
        (tmp_path / "frames.json").read_text("utf-8"))
    same = dict(risen.answer["actuation"])
    assert same.pop("by_hand") and same.pop("hands") is not None and answer["actuation"] == same


def test_the_folder_holds_what_actuation_json_lists(risen):
    assert set(risen.answer["files"]) == FILES
    assert {file.name for file in risen.folder.iterdir()} == FILES | {"actuation.json"}


def test_frames_lead_from_the_layout_along_falling_energy(risen):
    first, last = risen.frames[0], risen.frames[-1]
    corners = front_corners(risen.design, np.array(first["poses"]))
    assert corners[:, :, :2] == pytest.approx(np.asarray(risen.design.T), abs=1e-6)
    assert corners[:, :, 2] == pytest.approx(0, abs=1e-6)
    assert first["stretch"] == pytest.approx(risen.design.parameters.get("tau"))
    block = risen.answer["actuation"]
    # Energy does not rise in a step; contact points that are found anew between steps change it.
    assert block["largest_rise_n_mm"] <= 1e-9 * first["energy"]
    assert block["found_anew_n_mm"] < 0.05 * first["energy"]
    for name, sign, less in (("energy", -1, block["found_anew_n_mm"]), ("friction", 1, 0), ("time", 1, 0)):
        steps = sign * np.diff([frame[name] for frame in risen.frames])
        assert (steps >= -less).all()
    assert last["energy"] == pytest.approx(risen.answer["actuation"]["energy_n_mm"])


def test_fold_frames_keep_every_tile_rigid(risen):
    faces = np.array(risen.fold["faces_vertices"])
    assert len(faces) == 24 and len(risen.fold["file_frames"]) == len(risen.frames) > 5
    sides = {tuple(sorted(side)) for face in faces.tolist() for side in zip(face, face[1:] + face[:1])}
    assert sorted(tuple(sorted(edge)) for edge in risen.fold["edges_vertices"]) == sorted(sides)
    assert risen.fold["edges_assignment"] == ["B"] * 72

    def edges(frame):
        corners = np.array(frame["vertices_coords"])[faces]
        return np.linalg.norm(corners - np.roll(corners, 1, 1), axis=2)

    for frame in risen.fold["file_frames"]:
        assert frame["frame_inherit"] and frame["frame_parent"] == 0
        assert edges(frame) == pytest.approx(edges(risen.fold), abs=1e-5)


def test_the_page_needs_nothing_beside_it(risen):
    page = (risen.folder / "actuation.html").read_text("utf-8")
    hands = json.loads((risen.folder / "frames.json").read_text("utf-8"))["hands"]
    assert f"FRAMES={len(risen.frames) + len(hands)}," in page and "small-cap" in page
    assert not re.search(r"(src|href)=[\"'](?!data:)", page)


def of_page(folder, name):
    """What the page gives its script."""
    page = (folder / "actuation.html").read_text("utf-8")
    return json.loads(re.search(rf"\b{name}=([\[{{].*?[\]}}]),[A-Z]+=", page)[1])


def test_the_page_names_what_hands_do_and_marks_tiles_that_stay_open(risen):
    block, count = risen.answer["actuation"], len(risen.frames)
    hands = json.loads((risen.folder / "frames.json").read_text("utf-8"))["hands"]
    shaken = block["by_hand"]["shaken_frame"] + 1
    assert of_page(risen.folder, "DOING") == [""] * count + ["shaking"] * shaken + ["pressing"] * (
        len(hands) - shaken)
    marks = of_page(risen.folder, "MARKS")
    ends = {count - 1: block, count + shaken - 1: block["by_hand"]["shaken"]}
    for frame, end in ends.items():
        marked = marks.get(str(frame), [0] * 24)
        assert {tile for tile in range(24) if marked[tile] & 1} == {
            tile for pair in end["open_contacts"] for tile in pair}
    assert block["open_contacts"] and {int(frame) for frame in marks} <= {*ends, count + len(hands) - 1}
    page = (risen.folder / "actuation.html").read_text("utf-8")
    assert "tiles of contacts that stay open" in page and f"comes to rest: frame {count}" in page


def test_tiles_that_wedge_are_marked_at_the_end_of_the_path(project):
    found = project.latest(RISEN)
    pairs = [[k, k + 1] for k in range(0, 20, 2)]  # two more than are named
    trapped = dataclasses.replace(found, block={**found.block, "trap": True, "open_contacts": [[0, 23]],
                                                "sampled": [{"wedged": pairs}]})
    marks, end = tile_marks(trapped), found.path_count - 1
    assert marks[end] == [3] + [2] * 15 + [0] * 7 + [1]
    assert not any(mark & 2 for frame, one in marks.items() if frame != end for mark in one)
    said = next(one for one in trapped.findings() if one.kind == "actuation_trapped")
    assert "T00015-T00016 and 2 more" in str(said)
    legend = moving_view(trapped).rpartition("</script>")[2]
    assert all(words in legend for words in ("stay open", "wedge", "both", f"frame {end + 1}"))
    calm = dataclasses.replace(trapped, block={**trapped.block, "trap": False, "converged": False})
    assert end not in tile_marks(calm)


def test_the_step_file_has_the_tiles_where_the_path_ends(risen):
    text = (risen.folder / "small-cap-settled.step").read_text("utf-8")
    assert text.startswith("ISO-10303-21") and "T00024" in text
    points = np.array([[float(x) for x in found.split(",")]
                       for found in re.findall(r"CARTESIAN_POINT\('[^']*',\(([^)]*)\)\)", text)])
    corners = front_corners(risen.design, np.array(risen.frames[-1]["poses"])).reshape(-1, 3)
    # A boundary corner that no plane cuts is a point of the solids.
    near = np.linalg.norm(points[:, None] - corners[None], axis=2).min(0)
    assert (near < 1e-3).sum() > 12


def test_a_frame_is_gone_on_from(risen, curveups, tmp_path):
    ran = curveups("actuate", risen.source, "-o", tmp_path, "--set", "bumps=none", "friction_coefficient=0.6",
                   "--from", f"{risen.folder / 'frames.json'}:1")
    answer = json.loads((tmp_path / "actuation.json").read_text("utf-8"))
    assert answer["actuation"]["converged"] and ran.status in (0, 1)
    assert answer["actuation"]["trap"] is None and "sampled" not in answer["actuation"]
    frames = json.loads((tmp_path / "frames.json").read_text("utf-8"))["frames"]
    assert np.array(frames[0]["poses"]) == pytest.approx(np.array(risen.frames[1]["poses"]), abs=1e-6)


def test_it_stays_at_the_target_with_friction(risen, curveups, tmp_path):
    ran = curveups("actuate", risen.source, "-o", tmp_path, "--from", "target")
    assert ran.status == 0, ran.err


STILL = "[0, 0, 0, 1, 0, 0, 0]"


def frame_text(*rows):
    return '{"format": "curveups-frames", "frames": [{"poses": [' + ", ".join(rows) + "]}]}"


@pytest.mark.parametrize("text, words", [
    (None, "can't be read"), ("{", "no frames"), ('{"format": "curveups-frames", "frames": []}', "no frame"),
    (frame_text(STILL), "poses of 1 tiles"),
    (frame_text("[0, 0, 0, 9, 0, 0, 0]", *[STILL] * 23), "no rigid motion")])
def test_frames_that_do_not_do_are_refused(risen, curveups, tmp_path, text, words):
    path = tmp_path / "frames.json"
    if text is not None:
        path.write_text(text, "utf-8")
    ran = curveups("actuate", risen.source, "-o", tmp_path / "out", "--from", path)
    assert ran.status == 2 and words in ran.err.splitlines()[-1]
    assert not (tmp_path / "out").exists()


def test_hands_that_hold_it_are_refused(risen, curveups, tmp_path):
    ran = curveups("actuate", risen.source, "-o", tmp_path / "out", "--set", "gravity=held")
    assert ran.status == 2 and "gravity" in ran.err.splitlines()[-1] and not (tmp_path / "out").exists()


def test_numbers_of_frames_are_counted(tmp_path):
    path = tmp_path / "frames.json"
    path.write_text(frame_text(STILL), "utf-8")
    assert actuation.read_start(f"{path}:0", 1).poses.shape == (1, 7)
    with pytest.raises(CurveUpsError, match="there is no frame 1"):
        actuation.read_start(f"{path}:1", 1)


def test_a_compensated_design_settles_nearer_to_the_target(curveups, tmp_path):
    curveups("design", "saddle", "-o", tmp_path / "made", "--no-solids", "--set", "L=14", "settle=off")
    source = tmp_path / "made" / "design.json"
    ran = curveups("actuate", source, "-o", tmp_path, "--from", "target", "--compensate", "1")
    assert "beside the target in the mean" in ran.err, ran.err
    answer = json.loads((tmp_path / "actuation.json").read_text("utf-8"))
    block, given, found = answer["compensation"], *(native.read_design(path.read_text("utf-8"))
                                                    for path in (source, tmp_path / "design.json"))
    assert block["kept_round"] == 1 and block["mean_mm"][0] > 0.1
    assert block["mean_mm"][1] < 0.5 * block["mean_mm"][0]
    assert "design.json" in answer["files"]
    V, F = found.target
    assert np.array_equal(V, (given.target or (given.V, given.F))[0]) and np.array_equal(F, given.F)
    # What the answer says, computed anew: distances of corners after the motion that fits them best.
    settled = np.asarray(native.settle_design(found).corners).reshape(-1, 3)
    wanted = V[F].reshape(-1, 3)
    a, b = settled - settled.mean(0), wanted - wanted.mean(0)
    turned = Rotation.align_vectors(b, a)[0].apply(a)
    assert np.linalg.norm(turned - b, axis=1).mean() == pytest.approx(block["mean_mm"][1], abs=1e-6)


def test_what_can_not_be_compensated_leaves_everything_as_it_was(curveups, printed, tmp_path):
    source = tmp_path / "design.json"
    source.write_bytes((printed.folder / "design.json").read_bytes())
    ran = curveups("actuate", source, "-o", tmp_path, "--compensate", "1")
    assert ran.status == 2 and "would replace it" in ran.err and os.listdir(tmp_path) == ["design.json"]
    assert source.read_bytes() == (printed.folder / "design.json").read_bytes()
    for wrong in ("0", "10", "x", "1.5"):
        ran = curveups("actuate", source, "-o", tmp_path / "o", "--compensate", wrong)
        assert ran.status == 2 and "number of rounds from 1 to 9" in ran.err


@pytest.fixture(scope="module")
def project(risen):
    found = Project.of_design(risen.design)
    parameters = found.parameters
    parameters.set("bumps", "none")
    parameters.set("friction_coefficient", 0.6)
    found.parameters = parameters
    found.give(START, ActuationStart(hands=True))
    found.run(asked_by("actuate"))
    return found


def test_the_command_shows_what_the_stage_finds(risen, project):
    assert asked_by("actuate") == (RISEN,)
    assert RISEN not in asked_by("check", "cuts", "solve", "settle", "verify", "build", "print")
    found = project.latest(RISEN)
    assert json.loads(json.dumps(found.block)) == risen.answer["actuation"]
    path = found.frames[:found.path_count]
    assert np.array([frame["poses"] for frame in risen.frames]) == pytest.approx(path, abs=1e-9)
    assert set(found.open_tiles) == set(risen.answer["findings"][0]["tiles"])


def test_a_path_that_is_saved_comes_back_whole(project):
    text = saved_results.to_text(project.made())
    again, found = saved_results.from_text(text)[RISEN].result, project.latest(RISEN)
    assert again.frames.shape == (len(found.time), 24, 7) and (again.frames == found.frames).all()
    assert (again.energy == found.energy).all() and again.findings() == found.findings()
    # Four bytes a number: half of what they are made from.
    assert len(json.dumps(json.loads(text)["results"])) < 10_000 and again.poses.itemsize == 4
    assert np.linalg.norm(again.frames[:, :, 3:], axis=2) == pytest.approx(1, abs=1e-8)


def test_a_path_is_out_of_date_once_its_design_is_another(project):
    twin = project.copy()
    for name, value in (("friction_coefficient", 0.21), ("H_body", 3.2), ("thickness_front", 0.4)):
        parameters = twin.parameters
        before = parameters.get(name)
        parameters.set(name, value)
        twin.parameters = parameters
        assert name in twin.out_of_date(RISEN)
        parameters.set(name, before)
        twin.parameters = parameters
        assert twin.out_of_date(RISEN) == ()
    for other in (actuation.read_start("target", 24), ActuationStart(hands=False),
                  ActuationStart(hands=True, release="together"), ActuationStart(hands=True, press=(3,)),
                  ActuationStart(hands=True, press=(3,), force=2.0)):
        twin.give(START, other)
        assert twin.out_of_date(RISEN) == (START,)


def test_the_report_plays_the_path_where_there_is_one(project, tmp_path):
    page = report(project.copy(), tmp_path, (), Job()).read_text("utf-8")
    found = json.loads((tmp_path / "report.json").read_text("utf-8"))
    check(found["actuation"], OPTIONAL["actuation"], "actuation")
    assert "actuate" in {row["name"] for row in found["stages"]}
    path = project.latest(RISEN)
    assert f"FRAMES={len(path.time)}," in page and "<canvas" in page and str(path.findings()[0])[1:] in page
    said = [one["what"] for one in found["warnings"]]
    assert [str(one) for one in path.findings() if one.kind != "actuation_arrives"] == said
    other = project.copy()
    parameters = other.parameters
    parameters.set("friction_coefficient", 0.3)
    other.parameters = parameters
    assert "<canvas" not in report(other, tmp_path, (), Job()).read_text("utf-8")
    assert "actuation" not in json.loads((tmp_path / "report.json").read_text("utf-8"))


def test_a_row_of_the_benchmark_fits_the_table_of_the_page(project, tmp_path):
    block, page = project.latest(RISEN).block, tmp_path / "actuation.md"
    page.write_text((actuated.DOCS / "actuation.md").read_text("utf-8"), "utf-8")
    ends = {**block, "name": "small, no bumps", "tiles": 24, "processor": 1.25}
    restless = {**ends, "name": "small, bumps", "arrives": None, "converged": False, "trap": None}
    actuated.renew([ends, restless], page, {"actuation": actuated.cells})
    lines = page.read_text("utf-8").splitlines()
    head = next(line for line in lines if line.startswith("| design | tiles | arrives |"))
    rows = {line.split("|")[1].strip(): line.split("|") for line in lines if line.startswith("| small, ")}
    assert rows.keys() == {"small, no bumps", "small, bumps"}
    assert all(len(row) == len(head.split("|")) for row in rows.values())
    assert rows["small, no bumps"][3].strip() == "no" and rows["small, bumps"][3].strip() == "no answer"
    assert f"{block['shortfall_mm']:.1f}, {len(block['open_contacts'])} of" in rows["small, no bumps"][4]


def stopped_after(count):
    """A job that is stopped when tiles have moved so many steps."""
    seen = set()  # the same may be said again where time goes by

    def progress(what, fraction):
        if what == "actuate":
            seen.add(fraction)
        return len(seen) <= count

    return Job(progress)


def test_a_path_that_was_stopped_goes_on_as_it_would_have(risen, project, tmp_path):
    first = Project.of_design(risen.design)
    first.parameters = project.parameters
    whole = project.latest(RISEN)
    stopped = first.run(("bodies", *asked_by("actuate")), stopped_after(whole.block["steps"] // 2))
    actuation.write_actuation(stopped, tmp_path, Job())
    start = actuation.read_start(str(tmp_path / "frames.json"), 24)
    rest = Project.of_design(risen.design)
    rest.parameters = project.parameters
    rest.give(START, start)
    found = rest.run(asked_by("actuate"))[RISEN]
    assert 0 < stopped[RISEN].block["steps"] < whole.block["steps"]
    assert found.block["steps"] + stopped[RISEN].block["steps"] == whole.block["steps"]
    for name in ("energy_n_mm", "open_contacts", "shortfall_mm", "arrives"):
        assert found.block[name] == whole.block[name]
    assert (found.memories[-1] == whole.memories[-1]).all()
    # Of another design the same frame has no memory, and the path ends elsewhere.
    other = dataclasses.replace(start, of="another")
    assert other.content != start.content
    rest.give(START, other)
    assert rest.run(asked_by("actuate"))[RISEN].block["energy_n_mm"] != whole.block["energy_n_mm"]
    # From a frame that it came by as well.
    rest.give(START, actuation.read_start(f"{tmp_path / 'frames.json'}:3", 24))
    found = rest.run(asked_by("actuate"))[RISEN]
    assert found.block["steps"] == whole.block["steps"] - 3
    assert found.block["energy_n_mm"] == whole.block["energy_n_mm"]
    assert "contacts_anew" not in found.block
    # Others may have no memory, and the answer says so.
    frames = json.loads((tmp_path / "frames.json").read_text("utf-8"))
    del frames["frames"][3]["memory"]
    (tmp_path / "frames.json").write_text(json.dumps(frames), "utf-8")
    rest.give(START, actuation.read_start(f"{tmp_path / 'frames.json'}:3", 24))
    found = rest.run(asked_by("actuate"))[RISEN]
    assert found.block["contacts_anew"] and "actuation_anew" in [one.kind for one in found.findings()]


def test_a_path_that_ended_goes_on_from_its_last_frame(risen, curveups, tmp_path):
    curveups("actuate", risen.source, "-o", tmp_path, "--set", "bumps=none", "friction_coefficient=0.6",
             "--from", risen.folder / "frames.json")
    block = json.loads((tmp_path / "actuation.json").read_text("utf-8"))["actuation"]
    assert block["steps"] == 0 and block["energy_n_mm"] == risen.answer["actuation"]["energy_n_mm"]
    assert block["open_contacts"] == risen.answer["actuation"]["open_contacts"]


@pytest.mark.parametrize("spoil", [lambda text: text[:-8], lambda text: "%" + text[1:], lambda text: 7,
                                   lambda text: ""])
def test_a_memory_that_is_damaged_is_refused(risen, curveups, tmp_path, spoil):
    data = json.loads((risen.folder / "frames.json").read_text("utf-8"))
    data["frames"][-1]["memory"] = spoil(data["frames"][-1]["memory"])
    (tmp_path / "frames.json").write_text(json.dumps(data), "utf-8")
    ran = curveups("actuate", risen.source, "-o", tmp_path / "out", "--from", tmp_path / "frames.json",
                   "--set", "bumps=none", "friction_coefficient=0.6")
    assert ran.status == 2 and ran.err.splitlines()[-1].startswith("curveups: error: "), ran.err
    assert not (tmp_path / "out").exists()


def test_a_stop_keeps_the_path_so_far(risen):
    project = Project.of_design(risen.design)
    found = project.run(asked_by("actuate"), stopped_after(6))[RISEN]
    assert found.stopped and 1 <= len(found.frames) < len(risen.frames) and found.block["arrives"] is None
    assert [one.kind for one in found.findings()] == ["actuation_stopped"]
    project.forget_stopped()
    assert project.latest(RISEN) is None
    with pytest.raises(Stopped):
        project.run(asked_by("actuate"), stopped_after(0))
    assert project.latest(RISEN) is None


@pytest.fixture(scope="module")
def helped(risen, curveups, tmp_path_factory):
    folder = tmp_path_factory.mktemp("helped")
    ran = curveups("actuate", risen.source, "-o", folder, "--no-hands", "--try-changes",
                   "--set", "bumps=none", "friction_coefficient=0.6")
    answer = json.loads((folder / "actuation.json").read_text("utf-8"))
    return SimpleNamespace(folder=folder, ran=ran, help=answer["actuation"].pop("help"), answer=answer)


def test_changes_are_tried_beside_the_same_path(risen, helped):
    same = dict(risen.answer["actuation"])
    assert same.pop("by_hand") and same.pop("hands") is not None and helped.answer["actuation"] == same
    changed = [one["change"] for one in helped.help]
    for name in ("friction_coefficient", "d_gap_min", "H_body", "bumps"):
        assert [change for change in changed if list(change) == [name]], name
    before = {name: risen.design.parameters.get(name) for name in ("d_gap_min", "H_body")}
    for name, value in (("friction_coefficient", 0.6), ("bumps", "none"), *before.items()):
        assert all(change.get(name) != value for change in changed)
    assert len({json.dumps(change, sort_keys=True) for change in changed}) == len(changed)
    nearer = [one["what"] for one in helped.help
              if one["valid"] and one.get("shortfall_mm", np.inf) < same["shortfall_mm"]]
    assert nearer and [line for line in helped.ran.err.splitlines() if any(one in line for one in nearer)]


def test_a_change_is_judged_as_the_design_made_with_it_is(risen, helped):
    for name in ("friction_coefficient", "H_body"):
        said = next(one for one in helped.help if list(one["change"]) == [name])
        values = native.Parameters(risen.design.parameters)
        for key, value in {"bumps": "none", "friction_coefficient": 0.6, **said["change"]}.items():
            values.set(key, value)
        design = risen.design.with_parameters(values)
        if name == "H_body":
            laid = native.solve_layout(design.V, design.F, design.cuts, values)
            design = native.Design("again", values, design.V, design.F, laid.T, laid.q, design.cuts)
            repaired = native.repair_design(design)
            design, valid = repaired.design, repaired.status == "valid"
        else:
            valid = native.verify_design(design).valid
        block = native.actuate_design(design, answers=False).block
        assert said["valid"] == valid and said["arrives"] == block["arrives"]
        if block["arrives"] is not None:
            assert said["shortfall_mm"] == block["shortfall_mm"]
            assert said["open_contacts"] == block["open_contacts"]


def test_the_page_has_a_row_for_each_change(helped):
    page = (helped.folder / "actuation.html").read_text("utf-8")
    assert "What would help" in page and "<td>as it is</td>" in page
    for one in helped.help:
        assert f"<td>{one['what'].partition(': ')[0]}</td>" in page


def trial(value, **known):
    return Trial(Change({"L": value}), **known)


def test_the_best_change_comes_first():
    arrived = trial(1.0, valid=True, arrives=True, shortfall=0.1)
    near, far = (trial(far, valid=True, arrives=False, shortfall=far, open_contacts=((0, 1),), contacts=9)
                 for far in (2.0, 5.0))
    restless, invalid = trial(6.0, valid=True), trial(7.0, arrives=True, shortfall=0.1)
    refused = trial(8.0, error="no room for pins")
    order = [arrived, near, far, restless, invalid, refused]
    assert sorted(reversed(order), key=lambda one: one.rank) == order
    for one, words in ((arrived, "L=1: it arrives"), (near, "2 mm short of its shape with 1 of 9"),
                       (restless, "not known"), (invalid, "not valid"), (refused, "no room for pins")):
        assert words in str(one.finding) and "{" not in str(one.finding)
        json.dumps(one.entry(), allow_nan=False)
    found = ActuationHelp(tuple(order), 4.0)
    assert found.nearer == [arrived, near] and found.findings() == [arrived.finding, near.finding]
    assert [one.kind for one in ActuationHelp((far, refused), 4.0).findings()] == ["help_none"]
    assert ActuationHelp().findings() == [] and ActuationHelp().report() == {}


def test_a_cut_and_what_helps_together_are_tried():
    parameters = native.Parameters()
    parameters.set("L", 14)
    target, no_cuts = native.remesh(*native.builtin_target("half-sphere"), 14), np.zeros((0, 2), np.int32)
    layout = native.solve_layout(target.V, target.F, no_cuts, parameters)
    design = native.Design("dome", parameters, target.V, target.F, layout.T, layout.q, no_cuts)
    (cut,) = actuation_help._cuts(design, Job())
    along = np.linalg.norm(target.V[cut.edges[:, 0]] - target.V[cut.edges[:, 1]], axis=1)
    assert len(along) > 1 and cut.length == pytest.approx(along.sum())
    changed, valid = actuation_help._made(design, cut, Job())
    made = {frozenset(edge) for edge in changed.cuts.tolist()}
    assert made == {frozenset(edge) for edge in cut.edges.tolist()}
    assert valid == native.verify_design(changed).valid

    def short(change, distance, valid=True):
        return Trial(change, valid, False, distance)

    half, quarter = (Change({"friction_coefficient": value}) for value in (0.2, 0.1))
    thin = Change({"H_body": 2.0})
    tried = [short(half, 2.0), short(quarter, 3.0), short(cut, 3.5), short(thin, 1.0, valid=False),
             short(Change({"d_gap_min": 0.4}), 6.0)]
    together = actuation_help._together(tried, 5.0)
    assert together.values == {"friction_coefficient": 0.2} and together.edges is cut.edges
    assert actuation_help._together(tried[:2], 5.0) is None
    assert actuation_help._together([*tried, Trial(thin, True, True, 0.1)], 5.0) is None


def test_changes_need_a_path_from_flat(risen, curveups, tmp_path):
    ran = curveups("actuate", risen.source, "-o", tmp_path / "out", "--try-changes", "--from", "target")
    assert ran.status == 2 and "from flat alone" in ran.err and not (tmp_path / "out").exists()


def test_a_stop_keeps_the_changes_that_were_tried(risen, project):
    tried = []

    def progress(what, fraction):
        if what.startswith("trying ") and what not in tried:
            tried.append(what)
        return len(tried) < 3

    twin = project.copy()
    found = twin.run(asked_by("try changes"), Job(progress))
    assert found.stopped and found[HELP].stopped and len(found[HELP].trials) == 2
    assert {f"trying {one.change.findings()[0]}" for one in found[HELP].trials} == set(tried[:2])
    twin.forget_stopped()
    assert twin.latest(HELP) is None and twin.latest(RISEN) is project.latest(RISEN)


def test_nothing_is_tried_for_a_piece_that_arrives(risen):
    arriving = Project.of_design(risen.design)
    arriving.give(START, actuation.read_start("target", 24))
    found = arriving.run(asked_by("actuate", "try changes"))
    assert found[RISEN].block["arrives"] and found[HELP].trials == ()


def test_the_report_has_the_changes_that_were_tried(project, tmp_path):
    twin = project.copy()
    twin.run(asked_by("try changes"))
    page = report(twin, tmp_path, (), Job()).read_text("utf-8")
    tried = json.loads((tmp_path / "report.json").read_text("utf-8"))["actuation"]["help"]
    assert [one["what"] for one in tried] == [str(one.finding) for one in twin.latest(HELP).trials]
    assert all(f"<td>{one['what'].partition(': ')[0]}</td>" in page for one in tried)
    again = saved_results.from_text(saved_results.to_text(twin.made()))[HELP].result
    assert again.report() == twin.latest(HELP).report() and again.findings() == twin.latest(HELP).findings()


RELEASED = {"together": ["both off", "cut out"], "front-first": ["front off", "both off", "cut out"],
            "back-first": ["back off", "both off", "cut out"]}


def actuated_with(curveups, source, folder, *options, **more):
    ran = curveups("actuate", source, "-o", folder, *options, "--set", "bumps=none",
                   "friction_coefficient=0.6", **more)
    assert ran.status in (0, 1), ran.err
    return [json.loads((folder / name).read_text("utf-8")) for name in ("actuation.json", "frames.json")]


@pytest.mark.parametrize("release", RELEASED)
def test_every_release_ends_and_says_what_hands_did(risen, printed, curveups, tmp_path, release):
    answer, written = actuated_with(curveups, risen.source, tmp_path, "--release", release)
    block, frames = answer["actuation"], written["frames"]
    names = [phase["phase"] for phase in block["phases"]]
    assert block["release"] == release and names == RELEASED[release]
    said = [frame["phase"] for frame in frames]
    assert [name for name in dict.fromkeys(said)] == names
    assert [said.index(name) for name in names] == [phase["first_frame"] for phase in block["phases"]]
    assert sum(phase["steps"] for phase in block["phases"]) == block["steps"]
    # The answer is that of the end, and the end is that of the last phase.
    last = block["phases"][-1]
    for name in ("shortfall_mm", "open_contacts", "converged", "energy_n_mm"):
        assert last[name] == block[name]
    assert block["sampled"][-1]["shortfall_mm"] == block["shortfall_mm"]
    # Energy that the surplus stores goes with it; all else falls.
    for before, phase in zip(block["phases"], block["phases"][1:]):
        frame = frames[phase["first_frame"]]
        assert before["energy_n_mm"] - frame["energy"] == pytest.approx(phase["removed_n_mm"], abs=1e-6)
        assert frame["poses"] == frames[phase["first_frame"] - 1]["poses"]
        assert (phase["removed_n_mm"] > 100) == (phase["phase"] == "cut out")
        assert phase["energy_n_mm"] < frame["energy"]
    assert block["largest_rise_n_mm"] <= 1e-3 * frames[0]["energy"]
    assert frames[0]["energy"] > risen.frames[0]["energy"]  # the surplus is stretched as well
    # Where it jams all the same, hands go on from the end, with the piece alone.
    assert ("by_hand" in block) == (block["arrives"] is False) == ("hands" in written)
    for frame in written.get("hands", ()):
        assert frame["time"] > frames[-1]["time"] and "phase" not in frame
    # What is around the piece is what is printed, in the window of the kit's rings.
    report = json.loads((printed.folder / "report.json").read_text("utf-8"))
    assert block["surplus"]["anchors"] == report["sheets"]["anchors"] > 0
    again = sheets(block["surplus"]["box_mm"], risen.design.parameters)
    assert block["surplus"]["window_mm"] == again["window_mm"]
    page = (tmp_path / "actuation.html").read_text("utf-8")
    assert all(f"<td>{name}</td>" in page for name in names)
    assert of_page(tmp_path, "DOING")[:len(said)] == said


def test_anchors_of_a_path_stand_where_they_are_printed(risen):
    parameters = native.Parameters(risen.design.parameters)
    points, _, body = native.make_print_model(risen.design.with_parameters(parameters)).mesh("anchors")
    found = native.actuate_design(risen.design, answers=False, release="together").block["surplus"]
    assert found["anchors"] == body.max() + 1
    # To what bumps and cut corners of tiles shift them.
    assert np.array(found["box_mm"]) == pytest.approx(np.ptp(points[:, :2], axis=0), abs=0.6)


def test_cutting_out_is_what_it_does_without_the_option(risen, curveups, tmp_path):
    for name, options in (("with", ("--release", "cut")), ("without", ())):
        answer, _ = actuated_with(curveups, risen.source, tmp_path / name, "--no-hands", *options)
        assert not {"release", "surplus", "phases"} & set(answer["actuation"])
    assert {path.name: path.read_bytes() for path in (tmp_path / "with").iterdir()} == {
        path.name: path.read_bytes() for path in (tmp_path / "without").iterdir()}
    frames = json.loads((tmp_path / "with" / "frames.json").read_text("utf-8"))["frames"]
    assert frames == risen.frames and "phase" not in frames[0]


def test_a_release_has_the_same_bytes_with_any_number_of_threads(risen, curveups, tmp_path):
    for count in ("1", "2"):
        actuated_with(curveups, risen.source, tmp_path / count, "--no-hands", "--release", "back-first",
                      CURVEUPS_THREADS=count)
    for path in (tmp_path / "1").iterdir():
        assert path.read_bytes() == (tmp_path / "2" / path.name).read_bytes(), path.name


@pytest.mark.parametrize("options, words", [
    (("--from", "target"), "begins flat"), (("--set", "gravity=resting"), "without gravity")])
def test_a_release_that_can_not_be_is_refused(risen, curveups, tmp_path, options, words):
    ran = curveups("actuate", risen.source, "-o", tmp_path / "out", "--release", "together", *options)
    assert ran.status == 2 and words in ran.err.splitlines()[-1] and not (tmp_path / "out").exists()
    ran = curveups("actuate", risen.source, "-o", tmp_path / "out", "--release", "sideways")
    assert ran.status == 2 and "back-first" in ran.err


def test_changes_are_tried_with_the_same_release(project):
    design = project.latest("design").design.with_parameters(project.parameters)
    change = Change({"friction_coefficient": 0.1})
    tried = {release: actuation_help._try(design, change, 0, "", Job(), release)
             for release in ("cut", "together")}
    parameters = project.parameters
    parameters.set("friction_coefficient", 0.1)
    for release, one in tried.items():
        changed = design.with_parameters(parameters)
        block = native.actuate_design(changed, answers=False, release=release).block
        assert (one.shortfall, one.contacts) == (block["shortfall_mm"], block["contacts"])
    assert tried["cut"].shortfall != tried["together"].shortfall
