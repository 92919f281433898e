# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reasons, warnings and advice are values; sentences are made of them in one place, in every language."""

import json
import re
from html import escape

import pytest
from running import ROOT

from curveups.base.errors import CurveUpsError
from curveups.base.findings import Finding, Style, failed, refusal
from curveups.base.sentences import SENTENCES, WORDS
from curveups.base.native import native

WEAK = Finding.about("weak_points", [3, 1], points=2, f_min=0.0625, contacts=((1, 3),), least=-0.5,
                     weakest=((1, 3),))
# What kinds of findings are called where the native module makes them.
_NATIVE = re.compile(r'(?:push_back\(|return |= |why = \{|Finding \w+ = )\s*\{+\s*"([\w.-]+)"'
                     r'|(?:add|add_rows|of|reason)\(\s*"([\w.-]+)"|\bkind = "([\w.-]+)"'
                     r'|\? "([a-z_]+(?:\.\w+)?|[a-z]+-[a-z-]+)"\s*: "([\w.-]+)"')

_PYTHON = re.compile(r'(?:Finding(?:\.about)?|failed|_obstacle|warn|_warned)\(\s*(?:best, |division, )?'
                     r'"([\w.-]+)"')


def test_a_sentence_names_what_its_figures_are():
    assert str(WEAK) == ("2 contact points push too weakly: less than f_min = 0.0625 N at T00002-T00004; the "
                         "weakest has -0.5 N at T00002-T00004")
    assert WEAK.tiles == (1, 3) and WEAK.group == "weak_points"
    both = Finding.about("tried.valid", sizes=tuple(
        Finding.about(kind, value=value) for kind, value in (("size.L", 9.0), ("size.H_body", 2.5))))
    assert str(both) == "tried L = 9 mm, H_body = 2.5 mm: valid"
    many = Finding.about("thin_p_min", range(9), least=0.25, at=tuple(range(9)), printer="PolyJet", makes=0.6)
    assert "at T00001, T00002, T00003, T00004, T00005, T00006 and 3 more, below" in str(many)
    assert many.tiles == tuple(range(9))
    faces = Finding.about("not-finite", count=7, vertices=(0, 4, 5, 6, 7, 8, 9))
    assert "(vertices 1, 5, 6, 7, 8 and 2 more)" in str(faces) and faces.remedy() == "repair the file"


def test_a_style_writes_words_tiles_and_text():
    found = Finding.about("membrane.cuts", [2], side="back", tile=(2,), depth=0.3)
    style = Style(lambda text: {"back": "hinten"}.get(text, text).replace("would cut", "<schneidet>"),
                  lambda row: f"<{row}>", lambda text: escape(text, quote=False),
                  lambda number, how, unit: f"{1000 * number:{how}} k{unit}")
    assert "0.3 mm into" in str(found)
    said = found.sentence(style)
    assert said.startswith("the hinten membrane &lt;schneidet&gt; 300 kmm into the body of <2>"), said
    named = failed("unprintable", CurveUpsError("a < b", "", "do it"))
    assert named.sentence(style) == "the print can't be made: a &lt; b (do it)"


def test_values_survive_being_saved_and_damaged_ones_do_no_harm():
    nested = Finding("suggested", (), {"what_to_do": Finding.about("cut", [5], length=3.5, why=(WEAK,))})
    assert Finding.read(json.loads(json.dumps(nested.data))) == nested
    for figures in ({}, {"points": "two", "f_min": None, "contacts": 3, "least": (), "weakest": "x"}):
        assert str(Finding("weak_points", (), figures)) == "weak_points"
    assert str(Finding("of a later version")) == "of a later version"
    for data in ({}, {"kind": "x", "tiles": 3, "figures": {}}, {"kind": "x", "tiles": [], "figures": 4}, []):
        with pytest.raises((LookupError, TypeError, ValueError)):
            Finding.read(data)


def test_an_error_keeps_the_value_that_it_is():
    error = refusal(Finding.about("sharp_fold", [7, 2], count=2, H_body=3.0), "bowl.obj")
    assert error.tiles == (2, 7) and "(bowl.obj, T00003, T00008): lower H_body" in str(error)
    assert failed("unbuilt", error).tiles == (2, 7)


def test_an_entry_of_a_report_has_its_figures():
    entry = Finding.about("small_pin.side", [4], side="front", tile=(4,), area_mm2=3.5).entry()
    assert entry == {"what": "the front pin of T00005 has 3.5 mm2: valid, but less than A_pin_min asks for",
                     "kind": "small_pin", "tile": [4], "tiles": [4], "side": "front", "area_mm2": 3.5}


def test_every_kind_has_a_sentence():
    """Kinds in sources of the native module and of Python have a sentence, and no sentence is left over."""
    made = {kind for path in (ROOT / "native").rglob("*.cpp")
            if "Finding" in (text := path.read_text("utf-8")) or "add_rows" in text or "bump" in path.name
            for found in _NATIVE.findall(text) for kind in found if kind}
    assert {"weak_points.pulling", "membrane.cuts", "degenerate-faces", "cut.tip", "gap.somewhere",
            "inconsistent-orientation", "bodies_meet", "no_balance", "in_the_air.held"} <= made
    python = {kind for path in (ROOT / "Workbench").rglob("*.py")
              for kind in _PYTHON.findall(path.read_text("utf-8"))}
    assert python <= set(SENTENCES), python - set(SENTENCES)
    sources = "".join(path.read_text("utf-8") for folder, ending in (("native", "cpp"), ("Workbench", "py"))
                      for path in (ROOT / folder).rglob(f"*.{ending}") if path.name != "sentences.py")
    stems = {kind for kind in SENTENCES if f'"{kind}"' not in sources}
    assert not {kind for kind in stems if f'"{kind.rpartition(".")[0]}' not in sources}, stems


def test_native_findings_are_values():
    mesh = native.builtin_target("disc", 0.5)
    closed, = [one for one in native.check_mesh(*mesh, 1e-3, True) if one.kind == "too-large"]
    found = Finding.of(closed)
    assert "tiles of L = 0.001 mm" in str(found) and "choose a larger L" in found.remedy()
    assert {"front", "back", "gap", "pin area"} <= set(WORDS)
