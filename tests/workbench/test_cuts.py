# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts picked by mouse in FreeCAD's window: chains, undo, the layout, suggestions."""

import threading

import FreeCAD
import FreeCADGui
import numpy as np
import Part
import pytest
from curveups.features import actions, document as designs
from curveups.window.cuts import aligned
from curveups.window.overlays import overlay_of
from curveups.window.run import Task
from robot import (action, click, close_panel, display, keys, on_screen, picture, press, QtGui,
                   report, settle, until, widget, window)
from steps import begin, click_edge, edge_at, example, LIVE, move_to, panel

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


def test_a_run_of_another_command_goes_on_while_edges_are_cut(pictures):
    document, design = cutting()
    release, ended = threading.Event(), []
    task = Task("Report", lambda job: release.wait(60), lambda design, value: ended.append(value))
    LIVE.start(design, task)
    edge = click_edge(design, 0, 0)
    assert edges(design) == {edge} and LIVE.busy
    until(lambda: "at work" in panel().form.line.text(), 10, "the reason")
    close_panel()
    assert LIVE.busy
    release.set()
    until(lambda: ended == [True], 60, "the report")
    FreeCAD.closeDocument(document.Name)


def test_cuts_that_are_no_edges_are_named_and_replaced(pictures):
    document, design = cutting()
    design.Cuts.Edges = [0, 99999]
    until(lambda: "no edge of the target" in panel().form.line.text(), 10, "the message")
    edge = click_edge(design, 0, 0)
    quiet()
    assert edges(design) == {edge} and "Traceback" not in report(), report()
    close_panel()
    FreeCAD.closeDocument(document.Name)


def test_a_layout_lies_as_the_one_before(pictures):
    """Tiles lie in the plane as least squares turn them to those before."""
    document, design = cutting()

    def cut(x, y):
        click_edge(design, x, y)
        quiet()
        return overlay_of(design).scene.flat[:, :3, :2]

    first, second = cut(0, 0), cut(0, 22)
    assert np.abs(aligned(second, first) - second).max() < 1e-6
    angle = np.radians(130)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    assert np.abs(aligned(first @ turn + (7, -3), first) - first).max() < 1e-9
    FreeCAD.closeDocument(document.Name)  # with its panel open
    until(lambda: panel() is None, 5, "the panel to go")


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


def test_edges_of_a_target_that_is_out_of_date_can_be_cut(pictures):
    document, design = example("half-sphere", L=16)
    actions.solve(design)
    document.recompute()
    overlay = overlay_of(design)
    solved = len(design.Target.Mesh.Facets)

    # Undo leads back to the layout of the design.
    press("CurveUps_Cuts")
    until(lambda: overlay.scene is not None and not LIVE.busy, 60, "the layout")
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewTop()
    view.fitAll()
    click_edge(design, 0, 0)
    quiet()
    assert overlay.legend.content.notes == ("layout with these cuts",), overlay.legend.content
    document.undo()
    until(lambda: overlay.legend.content.notes != ("layout with these cuts",), 10, "the design")
    until(lambda: panel().form.doing.isHidden(), 10, "the panel to say nothing")

    design.L = 20
    document.recompute()
    close_panel()
    press("CurveUps_Cuts")
    assert LIVE.busy and "being divided" in panel().form.line.text(), panel().form.line.text()
    close_panel()
    assert not LIVE.busy and "cancelled" not in window.statusBar().currentMessage()
    press("CurveUps_Cuts")
    quiet()
    assert panel().form.line.text() == "" and 0 < len(overlay.scene.F) < solved
    view.viewTop()
    view.fitAll()
    settle(300)
    edge = click_edge(design, 0, 0)
    assert edges(design) == {edge}, panel().form.line.text()
    quiet()
    picture("of-a-target-out-of-date")
    assert overlay.scene.flat is not None and action("CurveUps_ShowFlat").isEnabled()
    close_panel()
    until(lambda: len(overlay.scene.F) == solved, 10, "the layout as it was")
