# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verdicts without solids: what they cover, and that they do not pass as more."""

import json

import numpy as np

from curveups.base.findings import Finding
from curveups.base.native import native
from curveups.project.project import Project
from curveups.stages.design import Clearances
from curveups.project.project import judge


def test_tiles_that_meet_as_printed_are_named(designed):
    design = designed.json("design.json")
    # The first tile onto its neighbour: still congruent.
    shift = [b - a for a, b in zip(*(np.mean(design["T"][tile], axis=0) for tile in (0, 1)))]
    design["T"][0] = [[x + 0.7 * shift[0], y + 0.7 * shift[1]] for x, y in design["T"][0]]
    results = Project.of_design(native.read_design(json.dumps(design))).run(("clearances",))
    assert results["clearances"].flat_mm == 0
    assert results.verdict.valid is False
    assert any("meet in the flat layout (T00001, T0" in str(reason) and reason.tiles[0] == 0
               for reason in results.verdict.reasons)


def test_what_a_verdict_does_not_cover_is_said(designed, printed):
    bare, whole = designed.json("report.json"), printed.json("report.json")
    assert bare["valid"] is True and whole["valid"] is True
    assert any("solids" in text for text in bare["not_covered"])
    assert any("printer" in text for text in bare["not_covered"])
    assert "not_covered" not in whole
    assert "Not covered" in (designed.folder / "report.html").read_text(encoding="utf-8")
    # The closed form is the one that the check of the solids reports.
    assert bare["clearances"]["min_flat_mm"] == whole["solids"]["min_clearance_flat_mm"] > 0
    assert whole["clearances"] == bare["clearances"]


def test_a_reason_that_several_results_give_is_said_once():
    reason = Finding.about("unprintable", error="too thin")
    twice = Clearances(broken=(reason,))
    assert judge({"a": twice, "b": twice}).reasons == (reason,)
