# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups design --follow`: tiles, cuts and parameters of an earlier design go along with its target."""

import json

import numpy as np
import pytest
from made import project, sheet
from schema import check_report
from shapes import obj_text

from curveups.project.following import carry_along
from curveups.stages.cut_request import CutRequest, interior_edges
from curveups.stages.following import Earlier
from curveups.stages.stage import Job

FAST = ("--no-solids", "--set", "run_settling=off")


def cap(height):
    return sheet(lambda x, y: -height * (x * x + y * y) / 900, 45)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("follow")
    for name, height in (("low", 4.0), ("high", 4.4)):
        (made / f"{name}.obj").write_text(obj_text(*cap(height)))
    cut = {"polylines": [[[45, 0, -4 * 45 * 45 / 900], [20, 0, -4 * 20 * 20 / 900]]]}
    (made / "cuts.json").write_text(json.dumps(cut))
    return made


@pytest.fixture(scope="module")
def earlier(folder, curveups):
    out = folder / "earlier"
    ran = curveups("design", folder / "low.obj", "-o", out, *FAST, "--set", "L=9", "H_body=2.5", "--cuts",
                   folder / "cuts.json")
    assert ran.status == 0, ran.err
    return out / "design.json"


def read(out):
    report = json.loads((out / "report.json").read_text("utf-8"))
    check_report(report)
    return json.loads((out / "design.json").read_text("utf-8")), report


def test_tiles_cuts_and_parameters_go_along(curveups, folder, earlier, tmp_path):
    ran = curveups("design", folder / "high.obj", "-o", tmp_path, *FAST, "--follow", earlier)
    assert ran.status == 0, ran.err
    before, (design, report) = json.loads(earlier.read_text("utf-8")), read(tmp_path)
    assert design["F"] == before["F"] and len(design["F"]) > 100
    assert design["cuts"] == before["cuts"] and len(before["cuts"]) > 1
    assert design["parameters"]["L"] == 9 and design["parameters"]["H_body"] == 2.5
    assert report["target"]["tiling"] == {"followed": True, "kept": len(design["F"]), "new": 0}
    assert report["target"]["mean_edge_mm"] == pytest.approx(9, rel=0.05)
    assert f"the tiles follow the target: {len(design['F'])} kept, 0 new" in ran.err
    assert report["deviation"]["max_mm"] < 0.5


def test_a_target_of_another_size_is_tiled_anew_with_the_cuts_at_their_places(curveups, folder, earlier,
                                                                              tmp_path):
    ran = curveups("design", folder / "high.obj", "-o", tmp_path, *FAST, "--follow", earlier, "--set",
                   "scale=1.5")
    design, report = read(tmp_path)
    assert report["target"]["tiling"]["followed"] is False
    assert "too large or too small" in report["target"]["tiling"]["why"]
    assert "tiled anew" in ran.err
    ends = np.array(design["V"])[np.unique(design["cuts"])]
    assert 20 * 1.5 - 9 < ends[:, 0].min() and np.abs(ends[:, 1]).max() < 9


@pytest.mark.parametrize("text, more, what", [
    ("{}", (), "design"), ("no JSON", (), "JSON"), (None, (), "can't be read"),
    ("earlier", ("--set", "L=auto"), "L=auto"), ("earlier", ("--no-remesh",), "--no-remesh")])
def test_mistakes_have_one_line(curveups, folder, earlier, tmp_path, text, more, what):
    file = tmp_path / "design.json"
    if text is not None:
        file.write_text(earlier.read_text("utf-8") if text == "earlier" else text)
    ran = curveups("design", folder / "high.obj", "-o", tmp_path / "out", *FAST, "--follow", file, *more)
    assert ran.status == 2 and len(ran.error_lines) == 1 and what in ran.error_lines[0], ran.err
    assert not (tmp_path / "out").exists()


def test_a_cut_goes_around_tiles_that_are_gone():
    def bump(height):
        return sheet(lambda x, y: height * np.exp(-(x * x + y * y) / 288), 60, 60)

    before = project(*bump(0), L=9.0)
    target = before.run(("target",))["target"]
    # A cut all along the middle, where the sheet grows, which splits edges.
    request = CutRequest(polylines=(np.array([[0.0, -60, 0], [0, 0, 0], [0, 60, 0]]),))
    before.give("cut request", request)
    cuts = before.run(("division",))["division"].edges
    after = project(*bump(26), L=9.0)
    carry_along(after, Earlier(target.V, target.F, cuts, None, 1.0), Job())
    followed = after.latest("target")
    assert followed.tiling.kind == "followed" and followed.tiling.figures["new"] > 0, str(followed.tiling)
    assert followed.followed.lost == 0
    edges = after.run(("division",))["division"].edges
    assert len(edges) >= len(cuts) and {tuple(edge) for edge in edges.tolist()} <= interior_edges(followed.F)
    # One line from border to border: two ends, and no forks.
    vertices, degree = np.unique(edges, return_counts=True)
    assert sorted(degree.tolist())[:3] == [1, 1, 2] and degree.max() == 2
    assert len(vertices) == len(edges) + 1
