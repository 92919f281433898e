# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts picked by mouse in FreeCAD's window: chains, undo, the quick layout, suggestions."""

import shutil

import pytest
from robot import ROBOT
from window import run_in_window

pytestmark = pytest.mark.skipif(not (shutil.which("xvfb-run") and shutil.which("xdotool")),
                                reason="there is no virtual display, or no xdotool")

STEPS = ROBOT + """
import numpy as np
from curveups.features import document as designs
from curveups.overlay import overlay_of
from curveups.panels.live import LIVE

def begin(name='half-sphere'):
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    settle(300)
    tidy()
    made = FreeCAD.newDocument('Made')
    made.UndoMode = 1
    settle(200)
    design = designs.new_design(made, name)
    FreeCADGui.runCommand('CurveUps_Cuts')
    until(lambda: FreeCADGui.Control.activeDialog(), 20, 'the panel')
    until(lambda: not LIVE.busy and overlay_of(design).scene is not None, 60, 'the target')
    settle(300)
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewTop()
    view.fitAll()
    settle(500)
    return made, design

def edges(design):
    return {tuple(sorted(edge)) for edge in designs.cuts_of(design).tolist()}

def edge_at(design, x, y):
    # The interior edge between two tiles whose middle is nearest to a place seen from above, on the front.
    overlay = overlay_of(design)
    corners, shift = overlay.figures()[0]
    F = overlay.scene.F
    seen = {}
    for tile in range(len(F)):
        for k in range(3):
            pair = tuple(sorted((int(F[tile][k]), int(F[tile][(k + 1) % 3]))))
            seen.setdefault(pair, []).append((corners[tile, k] + corners[tile, (k + 1) % 3]) / 2)
    inner = {pair: places for pair, places in seen.items() if len(places) == 2}
    return min(inner.items(), key=lambda one: np.hypot(*(one[1][0][:2] - (x, y))))

def point_in(design, pair):
    # A little inside one of its tiles, so that the pixel is on it.
    overlay = overlay_of(design)
    corners, shift = overlay.figures()[0]
    tile = next(t for t, face in enumerate(overlay.scene.F.tolist()) if set(pair) <= set(face))
    own = corners[tile, :3]
    face = overlay.scene.F[tile].tolist()
    ends = own[[k for k in range(3) if face[k] in pair]]
    return FreeCAD.Vector(*map(float, 0.9 * ends.mean(0) + 0.1 * own.mean(0)))

def move_to(design, pair):
    point = on_screen(point_in(design, pair))
    display('mousemove', point.x() - 3, point.y())
    display('mousemove', point.x(), point.y())
    settle(250)

def click_edge(design, x, y):
    pair, places = edge_at(design, x, y)
    move_to(design, pair)
    display('click', 1)
    settle(400)
    return pair

def quiet(seconds=60):
    until(lambda: not LIVE.busy, seconds, 'the quick layout')
    settle(400)
"""


def run(text, homes, tmp_path):
    return run_in_window(STEPS + text, homes[True], tmp_path, pictures=tmp_path / "pictures")


def test_a_chain_of_clicks_cuts_along_edges_and_each_click_is_undone_singly(homes, tmp_path):
    said = run("""
def work():
    made, design = begin()
    pair, places = edge_at(design, 0, 0)
    move_to(design, pair)
    picture('hovered')
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
    tree = widget('cuts')
    assert tree.topLevelItemCount() == 1 and tree.topLevelItem(0).text(1) == str(len(chain))
    quiet()
    assert overlay_of(design).scene.flat is not None, 'no quick layout is shown'
    assert 'Quick layout' in widget('doing').text()
    assert designs.state_of(design, 'Layout')[0] == 'empty'  # it is no result
    picture('chain')
    tree.topLevelItem(0).setSelected(True)
    settle(200)
    picture('selected')
    made.undo()
    settle(500)
    assert edges(design) == {first}
    made.redo()
    settle(500)
    assert edges(design) == chain
    made.undo(); made.undo()
    settle(500)
    assert not edges(design) and tree.topLevelItemCount() == 0
    quiet()
    close_panel()
    settle(500)
    assert 'Traceback' not in report(), report()
""", homes, tmp_path)
    assert "Traceback" not in said


def test_a_click_on_a_cut_takes_it_back_and_suggestions_are_accepted(homes, tmp_path):
    run("""
def work():
    made, design = begin()
    box = widget('live')  # no quick layout; its middle lies beside its text
    click_at(box.mapToGlobal(QtCore.QPoint(10, box.height() // 2)))
    until(lambda: not box.isChecked(), 10, 'the box')
    overlay = overlay_of(design)
    first = click_edge(design, 5, 0)
    assert edges(design) == {first}
    assert overlay.scene.flat is None
    move_to(design, first)
    display('click', 1)
    settle(400)
    assert not edges(design), (first, edges(design))
    assert not LIVE.busy
    click(widget('suggest'))
    until(lambda: not LIVE.busy, 120, 'the search')
    settle(300)
    listed = widget('suggested') if any(w.objectName() == 'suggested' and w.isVisible()
        for w in window.findChildren(QtGui.QTreeWidget)) else None
    picture('suggested')
    if listed is not None:
        assert 'predicted' in listed.topLevelItem(0).text(0)
        click(widget('accept'))
        assert len(edges(design)) > 1
        made.undo()
        settle(400)
        assert not edges(design)
    # The tiles were left alone by the clicks.
    assert not overlay.selected
    close_panel()
    settle(300)
    FreeCAD.closeDocument(made.Name)
    settle(300)
    assert 'Traceback' not in report(), report()
""", homes, tmp_path)
