# SPDX-License-Identifier: LGPL-2.1-or-later
"""Broken design files: status 2, one line that names the field, no file."""

import json
import re

import pytest


def at(*path):
    """An edit that sets what lies at `path` to the last item."""
    *steps, last, value = path

    def edit(design):
        place = design
        for step in steps:
            place = place[step]
        place[last] = value

    return edit


def in_another_unit(design):
    for name in "VT":
        design[name] = json.loads(json.dumps(design[name]), parse_float=lambda text: 1000 * float(text))


def without(name):
    return lambda design: design.pop(name)


BROKEN = {
    "other format": (at("format", "something-else"), "format"),
    "later version": (at("version", 99), "version"),
    "no V": (without("V"), "V"), "no F": (without("F"), "F"), "no T": (without("T"), "T"),
    "no q": (without("q"), "q"), "no parameters": (without("parameters"), "parameters"),
    "T is short": (lambda d: d["T"].pop(), "T"), "q is short": (lambda d: d["q"].pop(), "q"),
    "index beyond": (at("F", 0, 0, 10**6), "F"), "index below": (at("F", 0, 0, -1), "F"),
    "index is no integer": (at("F", 0, 0, 0.5), "F"),
    "vertex is text": (at("V", 0, 0, "x"), "V"), "vertex is null": (at("V", 0, 0, None), "V"),
    "vertex of two numbers": (at("V", 0, [1, 2]), "V"),
    "tile is not congruent": (at("T", 0, 0, 0, 1e4), "T"),
    "coordinates of another unit": (in_another_unit, "L"),
    "V is no list": (at("V", 7), "V"), "q is no block": (at("q", 0, [1, 2, 3]), "q"),
    "cut of no edge": (at("cuts", [[0, 0]]), "cut"), "cut beyond": (at("cuts", [[0, 99999]]), "cut"),
    "unknown parameter": (at("parameters", "frob", 1), "frob"),
    "parameter out of range": (at("parameters", "L", -7), "L"),
    "parameter of another type": (at("parameters", "bumps", 3), "bumps"),
}
TEXTS = {"empty": "", "no JSON": "{", "a list": "[]", "a number": "7", "NaN": None, "infinite": None,
         "binary": "\x00\x01\x02", "deep": "[" * 100000}


@pytest.mark.parametrize("command", ["verify", "export"])
@pytest.mark.parametrize("name", [*BROKEN, *TEXTS])
def test_broken_design(curveups, designed, tmp_path, name, command):
    design = designed.json("design.json")
    word = ""
    if name in BROKEN:
        edit, word = BROKEN[name]
        edit(design)
        text = json.dumps(design)
    elif name in ("NaN", "infinite"):
        design["V"][0][0] = float("nan" if name == "NaN" else "inf")
        text = json.dumps(design)
    else:
        text = TEXTS[name]
    broken = tmp_path / "broken.json"
    broken.write_text(text)
    ran = curveups(command, broken, "-o", tmp_path / "out")
    assert ran.status == 2, ran.err
    assert len(ran.err.splitlines()) == 1 and len(ran.error_lines) == 1, ran.err
    assert "broken.json" in ran.error_lines[0]
    assert re.search(rf"\b{word}s?\b", ran.error_lines[0]), ran.err
    assert not (tmp_path / "out").exists()


def test_export_refuses_what_needs_a_new_layout(curveups, designed, tmp_path):
    for setting in ("L=8", "d_gap_min=0.7", "run_verification=off"):
        ran = curveups("export", designed.folder / "design.json", "-o", tmp_path / "out",
                       "--set", setting)
        assert ran.status == 2 and setting.split("=")[0] in ran.error_lines[0]
        assert not (tmp_path / "out").exists()


def test_pins_turned_inside_out_are_named(curveups, designed, tmp_path):
    design = designed.json("design.json")
    design["q"][5][0] = [9.0, 9.0, 9.0]
    (tmp_path / "broken.json").write_text(json.dumps(design))
    ran = curveups("export", tmp_path / "broken.json", "-o", tmp_path / "out")
    assert ran.status == 2 and "T00006" in ran.error_lines[0], ran.err
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
