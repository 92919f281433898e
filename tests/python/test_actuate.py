# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups actuate`: the states, the path and the files that others read."""

import dataclasses
import json
import re
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from schema import OPTIONAL, check

from curveups.base.errors import Stopped
from curveups.base.native import native
from curveups.project import saved_results
from curveups.project.project import Project
from curveups.report.exports import report
from curveups.report.actuation import front_corners, open_tiles
from curveups.report.html import STATE_NAMES
from curveups.stages import RISEN, stages_of
from curveups.stages.actuation import RELAXED, STATES, findings
from curveups.stages.stage import Job

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))
import actuated  # noqa: E402

FILES = {"frames.json", "frames.fold", "actuation.html", "small-cap-built.step"}


@pytest.fixture(scope="module")
def risen(curveups, printed, tmp_path_factory):
    folder = tmp_path_factory.mktemp("risen")
    source = printed.folder / "design.json"
    ran = curveups("actuate", source, "-o", folder, "--set", "bumps=none", "friction_coefficient=0.6")
    read = {name: json.loads((folder / name).read_text("utf-8"))
            for name in ("actuation.json", "frames.json", "frames.fold")}
    design = native.read_design(source.read_text("utf-8"))
    return SimpleNamespace(folder=folder, ran=ran, source=source, design=design,
                           answer=read["actuation.json"], block=read["actuation.json"]["actuation"],
                           frames=read["frames.json"]["frames"], fold=read["frames.fold"])


@pytest.fixture(scope="module")
def project(risen):
    made = Project.of_design(risen.design)
    parameters = made.parameters
    parameters.set("bumps", "none")
    parameters.set("friction_coefficient", 0.6)
    made.parameters = parameters
    made.run(stages_of("actuate"))
    return made


def test_the_answer_and_its_status_agree(risen):
    assert risen.answer["format"] == "curveups-actuation" and risen.answer["status"] == "complete"
    assert risen.answer["tiles"] == 24 and risen.block["friction_coefficient"] == 0.6
    states = [risen.block[name] for name in STATES]
    assert risen.ran.status == (0 if all(state["converged"] for state in states) else 1)
    for state in states:
        assert state["mean_mm"] <= state["rms_mm"] <= state["max_mm"] <= state["hausdorff_mm"]
        assert state["mean_mm"] <= state["p95_mm"] <= state["max_mm"]
    assert risen.block["shaken"]["energy_n_mm"] <= risen.block["by_itself"]["energy_n_mm"]
    assert risen.block["shaken"]["taps"] >= 2 and risen.block["pressed"]["force_n"] > 0


def test_what_it_says_is_on_the_terminal_with_its_tiles(risen):
    said = [str(one) for one in findings(risen.block)]
    assert [one["what"] for one in risen.answer["findings"]] == said and len(said) == 5
    assert all(f"small-cap: {one}" in risen.ran.err for one in said)
    assert said[0].startswith("released and shaken, the piece is expected to lie ")
    tiles = {tile for pair in risen.block["by_itself"]["open_contacts"] for tile in pair}
    assert set(risen.answer["findings"][2]["tiles"]) == tiles


def block_of(**changed):
    state = {"converged": True, "mean_mm": 1.5, "max_mm": 4.25, "open_contacts": [[0, 1], [3, 5]]}
    return {"contacts": 9, "stopped": False, "relaxed": {**state, "mean_mm": 1.25}, "by_itself": state,
            "shaken": {**state, "taps": 7}, "pressed": {**state, "force_n": 2.0, "open_contacts": []},
            "spread": {"mean_mm": [1.25, 1.75], "varied": ["friction"]}, **changed}


def test_each_state_has_its_words():
    expected, relaxed, by_itself, shaken, pressed = findings(block_of())
    assert "1.5 mm from the target on average (1.2 mm to 1.8 mm)" in str(expected), str(expected)
    assert "2 of 9 contacts stay open" in str(expected) and expected.tiles == (0, 1, 3, 5)
    closed, *_ = findings(block_of(shaken={**block_of()["shaken"], "open_contacts": []}))
    assert "all contacts close. Pressed over the former it comes within 1.5 mm" in str(closed)
    assert "1.25 mm from the target" in str(relaxed)
    assert by_itself.tiles == (0, 1, 3, 5) and "1.5 mm" in str(by_itself) and "2 of 9" in str(by_itself)
    assert "7 taps" in str(shaken) and "4.25 mm at most" in str(shaken)
    assert "2 N a tile" in str(pressed) and "0 of 9" in str(pressed) and pressed.tiles == ()


@pytest.mark.parametrize("name", STATES)
def test_a_state_without_rest_is_named_and_warned_of(project, name):
    block = block_of()
    block[name] = {**block[name], "converged": False, "mean_mm": None, "max_mm": None}
    restless = dataclasses.replace(project.latest(RISEN), block=block)
    said, = restless.warnings()
    assert said.kind == f"actuation_restless.{name}" and "do not come to rest" in str(said)
    assert not restless.is_known


def test_a_path_that_was_stopped_is_not_known(project):
    block = block_of(stopped=True, shaken=None, pressed=None, spread={"mean_mm": None, "varied": []})
    stopped = dataclasses.replace(project.latest(RISEN), block=block)
    kinds = [one.kind for one in stopped.findings()]
    assert kinds == ["actuation_relaxed", "actuation_by_itself", "actuation_stopped"]
    assert [one.kind for one in stopped.warnings()] == ["actuation_stopped"] and not stopped.is_known


def test_the_folder_holds_what_actuation_json_lists(risen):
    assert set(risen.answer["files"]) == FILES
    assert {file.name for file in risen.folder.iterdir()} == FILES | {"actuation.json"}


def test_frames_lead_from_the_layout_through_all_states(risen):
    first = risen.frames[0]
    corners = front_corners(risen.design, np.array(first["poses"]))
    assert corners[:, :, :2] == pytest.approx(np.asarray(risen.design.T), abs=1e-6)
    assert corners[:, :, 2] == pytest.approx(0, abs=1e-6)
    assert first["stretch"] == pytest.approx(risen.design.parameters.get("tau"))
    loads = [frame["load"] for frame in risen.frames]
    assert [RELAXED, *dict.fromkeys(loads)] == list(STATES)
    for name in STATES[1:]:
        last = risen.block[name]["last_frame"]
        assert last == len(loads) - 1 - loads[::-1].index(name)
        assert risen.frames[last]["energy"] == pytest.approx(risen.block[name]["energy_n_mm"])
    assert (np.diff([frame["time"] for frame in risen.frames]) > 0).all()


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


def test_the_page_needs_nothing_beside_it_and_names_the_states(risen):
    page = (risen.folder / "actuation.html").read_text("utf-8")
    assert f"FRAMES={len(risen.frames)}," in page and "small-cap" in page
    assert not re.search(r"(src|href)=[\"'](?!data:)", page)
    doing = json.loads(re.search(r"\bDOING=(\[.*?\]),[A-Z]+=", page)[1])
    assert doing == [STATE_NAMES[frame["load"]] for frame in risen.frames]
    assert all(f"<td>{word}</td>" in page for word in STATE_NAMES.values())


def test_tiles_of_open_contacts_are_marked_where_the_piece_rests(project):
    piece = project.latest(RISEN)
    block = {**piece.block, "by_itself": {**piece.block["by_itself"], "open_contacts": [[0, 23]]},
             "shaken": {**piece.block["shaken"], "open_contacts": []},
             "pressed": {**piece.block["pressed"], "open_contacts": [[1, 2]], "converged": False}}
    marks = open_tiles(dataclasses.replace(piece, block=block))
    assert marks == {block["by_itself"]["last_frame"]: [tile in (0, 23) for tile in range(24)]}


def test_the_step_file_has_the_tiles_where_shaking_ends(risen):
    text = (risen.folder / "small-cap-built.step").read_text("utf-8")
    assert text.startswith("ISO-10303-21") and "T00024" in text
    points = np.array([[float(x) for x in found.split(",")]
                       for found in re.findall(r"CARTESIAN_POINT\('[^']*',\(([^)]*)\)\)", text)])
    poses = np.array(risen.frames[risen.block["shaken"]["last_frame"]]["poses"])
    corners = front_corners(risen.design, poses).reshape(-1, 3)
    # A boundary corner that no plane cuts is a point of the solids.
    near = np.linalg.norm(points[:, None] - corners[None], axis=2).min(0)
    assert (near < 1e-3).sum() > 12


def test_a_design_that_needs_little_friction_is_asked_for_by_a_flag(curveups, tmp_path):
    reports = []
    for flags in ((), ("--self-shaping",)):
        ran = curveups("design", "half-sphere", "-o", tmp_path, "--no-solids", "--set", "L=14", *flags)
        assert ran.status == 0, ran.err
        reports.append(json.loads((tmp_path / "report.json").read_text("utf-8")))
        check(reports[-1]["friction_needed"], OPTIONAL["friction_needed"], "friction_needed")
        needed = reports[-1]["friction_needed"]["coefficient"]
        assert f"needs friction {needed:.2g}" in ran.err and reports[-1]["friction_needed"]["tiles"]
    before, after = (one["friction_needed"]["coefficient"] for one in reports)
    assert after < 0.6 * before and after < reports[1]["unilateral"]["friction_coefficient"]
    assert reports[1]["deviation"] == reports[0]["deviation"]  # the surface stays where it is


def test_the_command_shows_what_the_stage_finds(risen, project):
    assert stages_of("actuate") == (RISEN,)
    assert RISEN not in stages_of("check", "cuts", "solve", "settle", "verify", "build", "print")
    piece = project.latest(RISEN)
    assert json.loads(json.dumps(piece.block)) == risen.block
    assert np.array([frame["poses"] for frame in risen.frames]) == pytest.approx(piece.frames, abs=1e-9)
    assert piece.built == "shaken"
    assert (piece.tiles("shaken") == piece.frame(risen.block["shaken"]["last_frame"])).all()
    for name, values in zip(STATES, piece.deviations):
        assert values.mean() == pytest.approx(piece.deviation(name).mean())
        assert values.mean() == pytest.approx(risen.block[name]["mean_mm"])
    pairs = risen.block["shaken"]["open_contacts"]
    assert set(piece.open_tiles) == {tile for pair in pairs for tile in pair}


def test_a_path_that_is_saved_comes_back_whole(project):
    text = saved_results.to_text(project.made())
    again, piece = saved_results.from_text(text)[RISEN].result, project.latest(RISEN)
    assert again.frames.shape == (len(piece.time), 24, 7) and (again.frames == piece.frames).all()
    assert (again.energy == piece.energy).all() and again.findings() == piece.findings()
    assert list(again.loads) == list(piece.loads)
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


def test_the_report_plays_the_path_where_there_is_one(project, tmp_path):
    page = report(project.copy(), tmp_path, (), Job()).read_text("utf-8")
    found = json.loads((tmp_path / "report.json").read_text("utf-8"))
    check(found["actuation"], OPTIONAL["actuation"], "actuation")
    assert "actuate" in {row["name"] for row in found["stages"]}
    path = project.latest(RISEN)
    assert f"FRAMES={len(path.time)}," in page and "<canvas" in page and str(path.findings()[0])[1:] in page
    other = project.copy()
    parameters = other.parameters
    parameters.set("friction_coefficient", 0.3)
    other.parameters = parameters
    assert "<canvas" not in report(other, tmp_path, (), Job()).read_text("utf-8")
    assert "actuation" not in json.loads((tmp_path / "report.json").read_text("utf-8"))


def test_a_row_of_the_benchmark_fits_the_table_of_the_page(project, tmp_path):
    block, page = project.latest(RISEN).block, tmp_path / "actuation.md"
    page.write_text((actuated.DOCS / "actuation.md").read_text("utf-8"), "utf-8")
    block = {**block, "tiles": 24, "friction_needed": 0.125, "seconds": 2.5}
    row = {"name": "small", "as laid out": {**block, "pressed": {**block["pressed"], "converged": False}},
           "little friction": None}
    actuated.renew([row], page, {"actuation": actuated.cells})
    lines = page.read_text("utf-8").splitlines()
    head = next(line for line in lines if line.startswith("| design | tiles | needs |"))
    cells, = ([cell.strip() for cell in line.split("|")] for line in lines if line.startswith("| small "))
    assert len(cells) == len(head.split("|")) and cells[7] == "no rest, -"
    assert cells[2:4] == ["24", "0.12, -"]
    assert cells[5] == f"{block['by_itself']['mean_mm']:.2f}, -"


def stopped_after(count):
    """A job that is stopped when tiles have moved so many steps."""
    seen = set()  # the same may be said again where time goes by

    def progress(what, fraction):
        if what == "releasing":
            seen.add(fraction)
        return len(seen) <= count

    return Job(progress)


def test_a_stop_keeps_the_path_so_far(risen):
    project = Project.of_design(risen.design)
    piece = project.run(stages_of("actuate"), stopped_after(6))[RISEN]
    assert piece.stopped and 1 <= len(piece.frames) < len(risen.frames)
    assert [one.kind for one in piece.findings()] == ["actuation_relaxed", "actuation_stopped"]
    assert piece.built == RELAXED and len(piece.deviations) == 1
    project.forget([RISEN])
    assert project.latest(RISEN) is None
    with pytest.raises(Stopped):
        project.run(stages_of("actuate"), Job(lambda what, fraction: what != "relaxing"))
    assert project.latest(RISEN) is None
