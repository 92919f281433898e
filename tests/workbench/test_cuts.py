# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts picked by mouse in FreeCAD's window: chains, undo, the layout, suggestions."""

import FreeCAD
import FreeCADGui
import numpy as np
import Part
import pytest
from curveups.features import document as designs
from curveups.window.overlays import overlay_of
from robot import (click, close_panel, display, keys, on_screen, picture, press, QtGui,
                   report, settle, until, widget, window)
from steps import begin, click_edge, edge_at, LIVE, move_to

pytestmark = pytest.mark.freecad(window=True)


def cutting(name="half-sphere"):
    """A new design, with the panel of cuts and its target from above."""
    document = begin()
    design = designs.new_design(document, name)
    FreeCADGui.runCommand("CurveUps_Cuts")
    until(lambda: FreeCADGui.Control.activeDialog(), 20, "the panel")
    until(lambda: not LIVE.busy and overlay_of(design).scene is not None, 60, "the target")
    settle(300)
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewTop()
    view.fitAll()
    settle(500)
    return document, design


def edges(design):
    return {tuple(sorted(edge)) for edge in designs.cuts_of(design).tolist()}


def quiet(seconds=60):
    until(lambda: not LIVE.busy, seconds, "the layout")
    settle(400)


def test_a_chain_of_clicks_cuts_along_edges_and_each_click_is_undone_singly(pictures):
    document, design = cutting()
    pair, places = edge_at(design, 0, 0)
    move_to(design, pair)
    picture("hovered")
    assert not edges(design)
    first = click_edge(design, 0, 0)
    assert edges(design) == {first}, (edges(design), first)
    quiet()
    second = click_edge(design, 0, 22)
    chain = edges(design)
    assert first in chain and second in chain and len(chain) > 2
    # One path: two vertices end it, all others join two of its edges.
    ends = [v for edge in chain for v in edge]
    assert sorted(ends.count(v) for v in set(ends))[:2] == [1, 1]
    assert all(ends.count(v) == 2 for v in set(ends) if ends.count(v) != 1)
    tree = widget("cuts")
    assert tree.topLevelItemCount() == 1 and tree.topLevelItem(0).text(1) == str(len(chain))
    quiet()
    assert overlay_of(design).scene.flat is not None, "no layout is shown"
    assert "Layout in" in widget("doing").text()
    assert design.Layout.Status == "empty"  # it is no result
    picture("chain")
    tree.topLevelItem(0).setSelected(True)
    settle(200)
    picture("selected")
    document.undo()
    settle(500)
    assert edges(design) == {first}
    document.redo()
    settle(500)
    assert edges(design) == chain
    document.undo()
    document.undo()
    settle(500)
    assert not edges(design) and tree.topLevelItemCount() == 0
    quiet()
    close_panel()
    settle(500)
    assert "Traceback" not in report(), report()


def test_the_surface_that_covers_its_target_is_hidden_while_edges_are_picked(pictures):
    document = begin()
    part = document.addObject("Part::Feature", "Cap")
    part.Shape = max(Part.makeSphere(40, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 35).Faces,
                     key=lambda face: face.Area)
    document.recompute()
    FreeCADGui.Selection.addSelection(part)
    press("CurveUps_NewDesign")
    until(lambda: len(document.Objects) > 1, 20, "the design")
    document.Design.L = 14
    document.recompute()
    undos = list(document.UndoNames)
    press("CurveUps_Cuts")
    until(lambda: not part.Visibility, 60, "the target to come into sight")
    quiet()
    assert not part.ViewObject.Visibility
    click_edge(document.Design, 0, 0)
    quiet()
    picture("uncovered")
    assert len(edges(document.Design)) == 1 and not part.Visibility
    close_panel()
    assert part.Visibility and part.ViewObject.Visibility
    assert len(document.UndoNames) == len(undos) + 2, document.UndoNames  # the target, and the cut


def test_a_click_on_a_cut_takes_it_back_and_suggestions_are_accepted(pictures):
    document, design = cutting()
    box = widget("live")  # no layout
    click(box)
    until(lambda: not box.isChecked(), 10, "the box")
    overlay = overlay_of(design)
    first = click_edge(design, 5, 0)
    assert edges(design) == {first}
    assert overlay.scene.flat is None
    move_to(design, first)
    display("click", 1)
    settle(400)
    assert not edges(design), (first, edges(design))
    assert not LIVE.busy
    for name, why in (("stop", "Nothing is at work"), ("accept", "Click Suggest first"),
                      ("remove", "There are no cuts")):
        button = widget(name)
        assert not button.isEnabled() and why in button.toolTip(), (name, button.toolTip())
    click(widget("suggest"))
    until(lambda: not LIVE.busy, 120, "the search")
    settle(300)
    trees = [tree for tree in window.findChildren(QtGui.QTreeWidget) if tree.objectName() == "suggested"]
    listed = widget("suggested") if any(tree.isVisible() for tree in trees) else None
    picture("suggested")
    if listed is not None:
        assert "predicted" in listed.topLevelItem(0).text(0)
        click(widget("accept"))
        assert len(edges(design)) > 1
        document.undo()
        settle(400)
        assert not edges(design)
    # The tiles were left alone by the clicks.
    assert not overlay.selected
    close_panel()
    settle(300)
    FreeCAD.closeDocument(document.Name)
    settle(300)
    assert "Traceback" not in report(), report()


@pytest.mark.all
def test_cuts_are_picked_in_the_flat_view_as_in_the_actuated_one(pictures):
    """On the layout, where both sides of an edge lie apart, and with both states side by side."""
    def inner_edges(design, beside=False):
        # Of a figure that is drawn: a point a little inside either tile, by the edge between them.
        overlay = overlay_of(design)
        corners, shift = overlay.figures()[beside]
        F = overlay.scene.F
        places: dict[tuple[int, ...], list] = {}
        for tile in range(len(F)):
            own = corners[tile, :3] + shift
            for k in range(3):
                pair = tuple(sorted((int(F[tile][k]), int(F[tile][(k + 1) % 3]))))
                places.setdefault(pair, []).append(0.45 * (own[k] + own[(k + 1) % 3]) + 0.1 * own.mean(0))
        return {pair: points for pair, points in places.items() if len(points) == 2}

    def edge_near(inner, x, y):
        # That is nearest to a place seen from above, from the middle of the figure.
        middle = np.mean(list(inner.values()), axis=(0, 1))
        return min(inner, key=lambda pair: np.hypot(*(inner[pair][0][:2] - middle[:2] - (x, y))))

    def click_at_place(place):
        point = on_screen(FreeCAD.Vector(*map(float, place)))
        display("mousemove", point.x() - 3, point.y())
        display("mousemove", point.x(), point.y())
        settle(250)
        display("click", 1)
        settle(400)
        quiet()

    document, design = cutting()
    overlay, view = overlay_of(design), FreeCADGui.ActiveDocument.ActiveView
    first = click_edge(design, 0, 0)  # on the target: its layout is what is drawn from now on
    quiet()
    assert overlay.morph() == 0 and overlay.scene.flat is not None, "the tiles lie flat"
    assert np.ptp(overlay.figures()[0][0][:, :3, 2]) < 1e-6
    view.viewTop()
    view.fitAll()
    settle(500)
    # The chain goes on across the flat tiles.
    inner = inner_edges(design)
    pair = edge_near(inner, 0, 25)
    click_at_place(inner[pair][0])
    chain = edges(design)
    assert first in chain and pair in chain and len(chain) > 2, (first, pair, chain)
    ends = [v for edge in chain for v in edge]
    assert sorted(ends.count(v) for v in set(ends))[:2] == [1, 1]
    assert all(ends.count(v) == 2 for v in set(ends) if ends.count(v) != 1)
    assert picture("flat-chain") > 12
    # Both sides of a slit are that cut: each takes it back.
    for side in (0, 1):
        click_at_place(inner_edges(design)[pair][side])
        assert edges(design) == chain - {pair}, side
        document.undo()
        settle(600)
        quiet()
        assert edges(design) == chain
    keys("Escape")
    settle(300)
    # Side by side: a click in either figure picks the same edge.
    design.ViewObject.Both = True
    settle(500)
    view.viewTop()
    view.fitAll()
    settle(500)
    for beside in (False, True):
        inner, before = inner_edges(design, beside), edges(design)
        pair = edge_near(inner, -20, -15)
        click_at_place(inner[pair][0])
        assert edges(design) == before | {pair}, (beside, edges(design) - before)
        assert picture(f"both-{beside}") > 12
        document.undo()
        settle(600)
        quiet()
        keys("Escape")
        settle(300)
    close_panel()
    settle(300)
    assert "Traceback" not in report(), report()
