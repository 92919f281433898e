# SPDX-License-Identifier: LGPL-2.1-or-later
"""Broken targets and designs: each ends with status 2, one clear line and no file."""

import json
import math
import re

import pytest
from running import dome

TRIANGLE = "v 0 0 0\nv 10 0 0\nv 0 10 0\n"
SHARP = "v 0 0 0\nv 0 20 0\nv 7 10 0\nv 7 10 0.3\nf 1 3 2\nf 2 4 1\n"


def scaled(text, factor):
    return re.sub(r"v (\S+) (\S+) (\S+)",
                  lambda m: "v %r %r %r" % tuple(factor * float(x) for x in m.groups()), text)


TEXTS = {  # a file of each format, and surfaces that can be no target
    "words.obj": "v zero zero zero\nf 1 2 3\n",
    **{f"words.{ending}": "hello" for ending in ("step", "iges", "brep")},
    "unknown.xyz": "0 0 0\n", "no-ending": "0 0 0\n", "empty.obj": "",
    "empty.step": "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n",
    "zero-area.obj": "v 0 0 0\nv 10 0 0\nv 20 0 0\nf 1 2 3\n",
    "one-point.obj": scaled(dome(3), 0.0), "huge.obj": scaled(dome(2), 1e12),
    "metres.obj": scaled(dome(3), 1e-3),
    "three-at-an-edge.obj": "v 0 0 0\nv 20 0 0\nv 0 20 0\nv 0 -20 0\nv 0 0 20\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
    "folded-shut.obj": SHARP,
}
AS_THEY_ARE = {  # remeshing would mend them
    "self-touching.obj": TRIANGLE + "v 20 20 0\nv 30 20 0\nf 1 2 3\nf 4 5 3\n",
    "folded-shut-as-is.obj": SHARP,
}


def expect_refusal(ran, folder, target, word=""):
    assert ran.status == 2, (ran.status, ran.err)
    # Progress lines may stand before it, nothing of a library's.
    assert all(line.startswith("curveups: ") for line in ran.err.splitlines()), ran.err
    assert len(ran.error_lines) == 1 and word in ran.error_lines[0], ran.err
    assert re.match(r"^curveups: error: .+ \(.*%s.*\): .+$" % re.escape(target.name), ran.error_lines[0])
    assert ran.out == "" and not (folder / "out").exists()


@pytest.mark.parametrize("name", [*TEXTS, *AS_THEY_ARE])
def test_hostile_target(curveups, tmp_path, name):
    target = tmp_path / name
    target.write_text(TEXTS.get(name, AS_THEY_ARE.get(name)))
    extra = ["--no-remesh"] if name in AS_THEY_ARE else []
    ran = curveups("design", target, "-o", tmp_path / "out", "--no-solids", *extra)
    expect_refusal(ran, tmp_path, target)


def test_a_spike_of_metres_is_refused_at_once_with_mending_too(curveups, tmp_path):
    target = tmp_path / "spike.obj"
    target.write_text("v 0 0 4000\n" + dome(3).partition("\n")[2])
    ran = curveups("design", target, "-o", tmp_path / "out", "--no-solids", "--set", "mend=on")
    expect_refusal(ran, tmp_path, target, "an edge of 39")
    assert "remeshing" not in ran.err, ran.err


def test_folder_as_target(curveups, tmp_path):
    target = tmp_path / "folder.obj"
    target.mkdir()
    expect_refusal(curveups("design", target, "-o", tmp_path / "out"), tmp_path, target)


@pytest.mark.parametrize("text, word", [
    ("{}", "no cuts"), ("{", "JSON"), ('{"edge": []}', "edge"), ('{"edges": [[0]]}', "pairs"),
    ('{"edges": [[0, 99999]]}', "edge"), ('{"polylines": [[[0,0,0],[0,0,"x"]]]}', "polyline"),
    ('{"polylines": [[[1e9,0,0],[2e9,0,0]]]}', "away")])
def test_broken_cuts(curveups, tmp_path, cap, text, word):
    cuts = tmp_path / "cuts.json"
    cuts.write_text(text)
    ran = curveups("design", cap, "-o", tmp_path / "out", "--no-remesh", "--no-solids", "--cuts", cuts)
    expect_refusal(ran, tmp_path, cuts, word)


def at(*path):
    """An edit that sets what lies at `path` to the last item."""
    *steps, last, value = path

    def edit(design):
        place = design
        for step in steps:
            place = place[step]
        place[last] = value

    return edit


DESIGNS = {  # and what native tests of the file's fields do not see
    "no V": (lambda d: d.pop("V"), "V"), "not finite": (at("V", 0, 0, math.nan), ""),
    "unknown parameter": (at("parameters", "frob", 1), "frob"),
    "pins inside out": (at("q", 5, 0, [9.0, 9.0, 9.0]), "T00006"),
}


@pytest.mark.parametrize("name", [*DESIGNS, "no JSON"])
def test_broken_design(curveups, designed, tmp_path, name):
    design, word = designed.json("design.json"), ""
    if name in DESIGNS:
        edit, word = DESIGNS[name]
        edit(design)
    broken = tmp_path / "broken.json"
    broken.write_text(json.dumps(design) if name in DESIGNS else "{")
    expect_refusal(curveups("export", broken, "-o", tmp_path / "out"), tmp_path, broken, word)


def test_export_refuses_what_needs_a_new_layout(curveups, designed, tmp_path):
    for setting in ("L=8", "d_gap_min=0.7", "run_verification=off"):
        ran = curveups("export", designed.folder / "design.json", "-o", tmp_path / "out", "--set", setting)
        assert ran.status == 2 and setting.split("=")[0] in ran.error_lines[0]
        assert not (tmp_path / "out").exists()


def test_verify_says_not_valid_of_pins_out_of_bounds(curveups, designed, tmp_path):
    design = designed.json("design.json")
    design["q"][5][0] = [0.1, 0.1, 0.1]
    (tmp_path / "loose.json").write_text(json.dumps(design))
    ran = curveups("verify", tmp_path / "loose.json", "-o", tmp_path / "out")
    assert ran.status == 1, ran.err
    report = json.loads((tmp_path / "out" / "report.json").read_text("utf-8"))
    assert report["valid"] is False
    assert any("insets leave their bounds" in reason for reason in report["reasons"])
    assert "physics" in report
    assert report["holds"] is None and any("turned inside out" in one["what"] for one in report["warnings"])
