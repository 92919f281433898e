# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections of report.html on pin smoothing, repair and the worst contacts."""

import re

import pytest

from curveups.report.html import render

PIN_SMOOTHING = {
    "largest_move_mm": 0.3, "remaining": 1,
    "pin_sides": [{"tile": 4, "side": "back", "area_before_mm2": 3.1}],
    "moved_vertices": [{"vertex": 7, "tiles": [3, 4], "mm": 0.3}, {"vertex": 2, "tiles": [4], "mm": 0.1}]}
REPAIR = {"status": "valid", "largest_move_mm": 0.2, "largest_vertex_move_mm": 0.0, "steps": [{}, {}],
          "blocked": [], "suggestions": [], "mended": [[0, 11], [2, 3]], "moved_vertices": []}


def changes(**report):
    return " ".join(re.sub(r"<[^>]+>", " ", render("changes.html", report=report)).split())


def test_moved_vertices_and_mended_contacts_are_named():
    text = changes(pin_smoothing=PIN_SMOOTHING, repair=REPAIR)
    assert "2 vertices moved by up to 0.3 mm" in text and "T00004, T00005" in text
    assert "T00001–T00012, T00003–T00004" in text and "no vertex moved" in text


def test_a_repair_that_ends_not_valid_says_what_is_left():
    ended = {**REPAIR, "status": "blocked", "blocked": [{"tiles": [0, 1], "reason": "no room"}],
             "cuts": ["a membrane would cut"]}
    assert "could not strengthen all contacts" in changes(repair=ended)
    ended["blocked"] = []
    assert "could not keep membranes from cutting into bodies" in changes(repair=ended)


def test_mending_says_what_it_did():
    block = {"actions": ["2 holes filled"], "moved_vertices": 3, "mean_mm": 0.5,
             "max_mm": 1.25, "hausdorff_mm": 0.75, "tiles": [3], "remaining": [4]}
    text = changes(mending=block)
    assert "The target was mended:" in text and "2 holes filled" in text and "1.25 mm" in text
    assert "still have too little space: T00005" in text
    assert "nothing to mend" in changes(mending={**block, "actions": [], "remaining": []})


def test_what_did_not_run_is_not_spoken_of():
    assert changes(contact_forces={}) == ""


@pytest.mark.parametrize("kind", ["designed", "printed"])
def test_the_worst_contacts_of_a_valid_design(kind, request):
    done = request.getfixturevalue(kind)
    report = done.json("report.json")
    assert report["valid"] is True
    worst = report["worst_contacts"]
    assert len(worst) == 5
    forces = [one["normal_min"] for one in worst]
    assert forces == sorted(forces)
    assert forces[0] == pytest.approx(report["contact_forces"]["normal_min"])
    page = (done.folder / "report.html").read_text(encoding="utf-8")
    assert "Worst contacts" in page and "–".join(f"T{tile + 1:05d}" for tile in worst[0]["tiles"]) in page
