# SPDX-License-Identifier: LGPL-2.1-or-later
"""`mend=off|on`: what scans and exchanged files bring, from one command to a valid design."""

import json
import math

import numpy as np
import pytest
from made import project, sheet, tent
from schema import NUMBER
from schema import check as check_block
from shapes import obj_text

BLOCK = {"actions": list, "moved_vertices": "count", "mean_mm": NUMBER, "max_mm": NUMBER,
         "border_max_mm": NUMBER,
         "hausdorff_mm": NUMBER, "tiles": list, "remaining": list}


def bowl(x, y):
    return 0.008 * (x * x + y * y)


def scan():
    """Noise of 0.12 mm on facets of 1 mm, a ragged boundary, two small holes and a crumb."""
    random = np.random.default_rng(1)
    V, F = sheet(bowl, 24, 48)
    V = V + random.normal(0, 0.12, V.shape)
    centre = V[F].mean(1)[:, :2]
    gone = np.zeros(len(F), bool)
    for place, radius in (((8, 5), 2.5), ((-10, 8), 2)):
        gone |= np.linalg.norm(centre - place, axis=1) < radius
    V = np.vstack([V, [[40, 40, 0], [42, 40, 0], [40, 42, 0]]])
    return V, np.vstack([F[~gone], [[len(V) - 3, len(V) - 2, len(V) - 1]]])


def jumble():
    """A fifth of the faces turned over, and forty of them there twice."""
    random = np.random.default_rng(1)
    V, F = sheet(bowl, 22, 16)
    turned = random.random(len(F)) < 0.2
    F[turned] = F[turned][:, ::-1]
    return V, np.vstack([F, F[random.integers(0, len(F), 40)]])


def fin():
    """Two sheets that touch in a corner, and a fin on an edge of the first."""
    V, F = sheet(bowl, 20, 12)
    other = V + [40, 40, 0]
    joined = np.where(F == 0, -1, F)  # its first vertex is the last of the first sheet
    both = np.vstack([V, other, [[1.0, 1.0, 4.0]]])
    return both, np.vstack([F, joined + len(V) * (joined >= 0) + len(V) * (joined < 0),
                            [[13 * 6 + 6, 13 * 6 + 7, len(both) - 1]]])


def thorn():
    """A vertex that leans through a bump beside it."""
    V, F = sheet(bowl, 22, 44)
    middle = 45 * 22 + 22
    V[middle] += [2.6, 0.2, 0.6]
    V[middle + 2, 2] += 0.4
    return V, F


@pytest.fixture
def run(curveups, tmp_path):
    """A target through `design`, without solids: how it ended, its report and its page."""
    def design(surface, *settings):
        path = surface
        if isinstance(surface, tuple):
            path = tmp_path / "given.obj"
            path.write_text(obj_text(*surface))
        more = [part for setting in settings for part in ("--set", setting)]
        ran = curveups("design", path, "-o", tmp_path / "out", "--no-solids", *more)
        report = tmp_path / "out" / "report.json"
        page = tmp_path / "out" / "report.html"
        return (ran, json.loads(report.read_text(encoding="utf-8")) if report.exists() else None,
                page.read_text(encoding="utf-8") if page.exists() else "")

    return design


@pytest.mark.parametrize("surface, said", [(scan, "holes filled"), (jumble, "turned"), (fin, "taken apart"),
                                           (thorn, "ran through others"), (tent, "vertices moved")])
def test_one_command_makes_a_valid_design(run, surface, said):
    ran, report, page = run(surface(), "mend=on", *(["H_body=5"] if surface is tent else []))
    assert ran.status == 0, ran.err
    assert report["valid"] is True
    block = report["mending"]
    check_block(block, BLOCK, "mending")
    assert any(said in action for action in block["actions"]), block["actions"]
    assert 0 <= block["mean_mm"] <= block["max_mm"] <= 2.0
    assert (block["max_mm"] > 0) == (block["moved_vertices"] > 0)
    assert "<h3>Mending</h3>" in page and "How far the mended target is" in page
    assert all(action.replace("&", "&amp;") in page for action in block["actions"])


def test_deviation_is_from_what_was_given(run):
    _, report, _ = run(tent(), "mend=on", "H_body=5", "verify=off")
    block, deviation = report["mending"], report["deviation"]
    assert block["hausdorff_mm"] > 0.3 and deviation["hausdorff_mm"] > 0.5 * block["hausdorff_mm"]
    _, report, _ = run(scan(), "mend=on", "verify=off")
    assert report["deviation"]["hausdorff_mm"] > 10  # the crumb, which is gone, was given
    assert report["deviation"]["mean_mm"] < 0.3


@pytest.mark.all
def test_a_surface_that_ends_too_far_from_the_target_is_named():
    """A bump that tiles are too large for, without an edge that could stay."""
    V, F = sheet(lambda x, y: 4 * math.exp(-(x * x + y * y) / 18), 40, 60)

    def far(**values):
        made = project(V, F, will_be_cut=False, mend="on", **values).run(("target smoothing",))
        return [one for one in made["target smoothing"].warnings() if one.kind == "mending.far"]

    found = far(L=14.0, mend_max=0.5)
    assert len(found) == 1 and 0.5 < found[0].figures["distance"] < 4
    assert "more than mend_max (0.5 mm)" in str(found[0])
    assert not far(L=4.0)


def test_without_mending_all_of_these_are_refused_with_a_way_out(run):
    for surface in (fin, thorn):
        ran, report, _ = run(surface())
        assert ran.status == 2 and report is None
        assert "or set mend=on (" in ran.error_lines[0], ran.err
    ran, report, _ = run(tent(12, 9), "H_body=5")
    assert ran.status == 2, ran.err
    assert "smooth the target there (mend=on)" in ran.error_lines[0], ran.err


def test_what_is_sound_stays_as_it_is(run, tmp_path):
    designs = []
    for mend in ("off", "on"):
        ran, report, _ = run("saddle", f"mend={mend}", "L=14")
        assert ran.status == 0
        design = json.loads((tmp_path / "out" / "design.json").read_text("utf-8"))
        designs.append({key: design[key] for key in ("V", "F", "T", "q")})
    assert report["mending"]["actions"] == [] and report["mending"]["max_mm"] == 0
    assert designs[0] == designs[1]


def test_mend_max_is_kept(run):
    _, report, _ = run(tent(), "mend=on", "mend_max=0.2", "H_body=5", "verify=off")
    assert report["mending"]["max_mm"] <= 0.2 + 1e-9


def test_a_sharp_fold_that_runs_into_the_border(run):
    """The border moves, as nothing else gives tiles room there."""
    V, F = sheet(lambda x, y: -1.0 * abs(x), 30, 20)
    ran, report, page = run((V, F), "mend=on")
    block = report["mending"]
    assert ran.status == 0
    assert 0 < block["border_max_mm"] <= block["max_mm"] <= 2
    assert any("of the border" in action for action in block["actions"]) and "of the border" in page
    _, inside, _ = run(tent(), "mend=on", "H_body=5", "verify=off")
    assert inside["mending"]["max_mm"] > 0 and inside["mending"]["border_max_mm"] == 0
