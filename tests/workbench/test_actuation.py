# SPDX-License-Identifier: LGPL-2.1-or-later
"""Actuate: the path from flat is computed, played, kept with the document, and told to be out of date."""

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from curveups.project.worker import WORKER
from curveups.window.overlays import overlay_of
from robot import (at_rest, click, close_panel, cut_off, display, picture, press,
                   QtCore, settle, until)
from steps import example, LIVE, opened, panel

pytestmark = pytest.mark.freecad(window=True)


def corners(design):
    """Front corners of the tiles as they are drawn."""
    return overlay_of(design).figures()[0][0][:, :3].copy()


def lies_flat(design):
    return np.ptp(corners(design)[:, :, 2]) < 1e-3


def ends(form):
    return form.frame.value() == form.frame.maximum()


def drag_to_the_left(slider):
    """From the right end, by the handle."""
    middle = slider.rect().center().y()
    start, end = (slider.mapToGlobal(QtCore.QPoint(x, middle)) for x in (slider.width() - 6, 6))
    display("mousemove", start.x(), start.y())
    display("mousedown", 1)
    display("mousemove", (start.x() + end.x()) // 2, start.y())
    half = slider.value()
    display("mousemove", end.x() - 10, start.y())
    display("mouseup", 1)
    settle(100)
    return half


def test_a_path_is_computed_played_and_kept(dome_document, pictures, tmp_path):
    document, design = opened(dome_document)
    design.Bumps, design.FrictionCoefficient = "none", 0.2
    document.recompute()
    at_rest()
    assert design.Actuation == "" and not design.ViewObject.Visibility
    press("CurveUps_Actuate")
    at_rest(300)
    form = panel().form
    assert design.Actuation == "current" and document.UndoNames[0] == "Actuate"
    until(lambda: ends(form), 60, "the path to be played")
    assert design.ViewObject.Visibility and not design.Tiles.ViewObject.Visibility
    assert form.frame.maximum() > 5 and form.verdict.text().count("<br>") == 4 and not form.note.isVisible()
    assert "pressed" in form.at.text()
    distances = overlay_of(design).legend.content
    assert 0 <= distances.low < distances.high < 20
    assert cut_off(form) == []
    end = corners(design)
    assert np.ptp(end[:, :, 2]) > 3 and picture("at-rest") > 12

    # The slider moves all tiles, each as it is.
    half = drag_to_the_left(form.frame)
    assert 0 < half < form.frame.maximum() and form.frame.value() == 0 and lies_flat(design)
    assert picture("flat") > 12
    sides = [np.linalg.norm(one - np.roll(one, 1, axis=1), axis=2) for one in (end, corners(design))]
    assert sides[0] == pytest.approx(sides[1], abs=1e-5)
    click(form.play)
    until(lambda: ends(form), 60, "the path to be played again")
    assert corners(design) == pytest.approx(end)
    if form.select.isEnabled():
        click(form.select)
        assert overlay_of(design).selected == sorted(overlay_of(design).selected) != []
        picture("open contacts")

    # What commands show takes the place of the path; the slider brings it back.
    press("CurveUps_ShowFlat")
    until(lambda: design.ViewObject.Morph == 0 and lies_flat(design), 10, "the flat layout")
    click(form.play)
    until(lambda: ends(form), 60, "the path once more")
    assert corners(design) == pytest.approx(end)
    close_panel()
    until(lambda: lies_flat(design), 10, "the design instead of the path")

    # It is kept with the document, and nothing is computed anew.
    document.saveAs(str(tmp_path / "kept.FCStd"))
    FreeCAD.closeDocument(document.Name)
    document, design = opened(tmp_path / "kept.FCStd")
    assert design.Actuation == "current"
    press("CurveUps_Actuate")
    until(lambda: np.allclose(corners(design), end), 10, "the end of the path")
    assert not LIVE.busy and ends(panel().form)

    # Of another design it is out of date, and says so.
    design.FrictionCoefficient = 0.3
    document.recompute()
    until(lambda: panel().form.note.isVisible(), 10, "the note")
    assert design.Actuation.startswith("out of date: ") and "FrictionCoefficient" in design.Actuation
    picture("out-of-date")
    design.FrictionCoefficient = 0.2
    document.recompute()
    until(lambda: not panel().form.note.isVisible(), 10, "the note to go")
    assert design.Actuation == "current"


def test_a_design_comes_to_need_little_friction(dome_document, pictures):
    document, design = opened(dome_document)
    press("CurveUps_Verify")
    at_rest(300)
    needed, surface = design.FrictionNeeded, design.Layout.Vertices
    assert needed > 0.01 and not design.SelfShaping
    close_panel()
    press("CurveUps_LittleFriction")
    at_rest(300)
    assert design.SelfShaping and 0 < design.FrictionNeeded < 0.8 * needed
    assert design.Layout.Vertices == surface and picture("little-friction") > 12
    assert "valid" in panel().form.verdict.text().lower()
    document.undo()
    until(lambda: design.FrictionNeeded == needed, 10, "the design before")


@pytest.mark.all
def test_a_run_that_is_cancelled_or_undone_leaves_nothing(pictures):
    document, design = example(L=14, Bumps="none")  # the dome rises within the time of a click
    FreeCADGui.runCommand("CurveUps_Solve")
    at_rest()
    steps = list(document.UndoNames)
    press("CurveUps_Actuate")
    form = panel().form
    click(form.cancel)
    until(lambda: not LIVE.busy, 10, "the end")
    assert WORKER.wait(60)
    assert design.Actuation == "" and document.UndoNames == steps and "cancelled" in form.line.text()
    assert not form.play.isEnabled()

    click(form.run)
    until(lambda: WORKER.status().what == "releasing" and WORKER.status().fraction > 0.26, 120,
          "tiles to move")
    click(form.stop)
    at_rest()
    until(lambda: ends(form), 60, "the path so far to be played")
    assert design.Actuation == "current" and "stopped" in form.verdict.text()
    click(form.run)  # anew, to its end
    at_rest(300)
    assert "stopped" not in form.verdict.text()
    document.undo()
    until(lambda: "stopped" in form.verdict.text(), 10, "the path before")
    document.undo()
    until(lambda: not form.play.isEnabled(), 10, "no path")
    assert design.Actuation == ""
