# SPDX-License-Identifier: LGPL-2.1-or-later
"""In a window: what transactions hold, solids that follow them and can be ended, deleting and copying."""

import FreeCAD
import FreeCADGui
import pytest
from curveups.features import document as documents
from curveups.project.worker import WORKER
from curveups.window import run
from robot import QtCore, QtGui, click_at, keys, picture, settle, tidy, tree_entry, until, window

pytestmark = pytest.mark.freecad(window=True)

PARTS = ("Target", "Cuts", "Layout", "Verification", "Tiles", "Support", "Anchors")


def opened(path):
    document = FreeCAD.openDocument(str(path))
    document.UndoMode = 1
    settle()
    return document, document.Design


def edit(document, name, value):
    document.openTransaction(f"Edit {name}")
    setattr(document.Design, name, value)
    document.recompute()
    document.commitTransaction()


def test_solids_follow_transactions(dome_document, monkeypatch):
    document, design = opened(dome_document)
    tiles, size = design.Tiles, document.UndoRedoMemSize
    # Edits in quick succession: solids are built for the last one alone.
    built, real = [], run.take_solids

    def take(obj, results):
        built.append((obj.HBody.Value, obj.AnchorRadius.Value))
        real(obj, results)

    monkeypatch.setattr(run, "take_solids", take)
    for thickness in (2.9, 2.8, 2.7):
        edit(document, "HBody", f"{thickness} mm")
        assert tiles.Status == "out of date"
    until(lambda: tiles.Status == "current")
    assert built == [(2.7, 4)] and abs(tiles.Shape.BoundBox.ZLength - 4.7) < 1e-6, built
    # No shapes in what can be undone, and following is no step of its own.
    assert document.UndoRedoMemSize - size < 2e5, document.UndoRedoMemSize
    assert document.UndoNames == ["Edit HBody"] * 3
    for _ in range(3):
        document.undo()
    assert design.HBody.Value == 3 and design.Verdict == "valid" and tiles.Status == "out of date"
    until(lambda: tiles.Status == "current")
    assert abs(tiles.Shape.BoundBox.ZLength - 5) < 1e-6
    # Nothing is built inside of an open transaction.
    document.openTransaction("Long")
    setattr(design, "HPin", "0.9 mm")
    document.recompute()
    run.LIVE._build()  # as after the pause
    assert not WORKER.busy and tiles.Status == "out of date"
    document.abortTransaction()
    settle(500)
    assert design.HPin.Value == 1 and tiles.Status == "current" and design.Verdict == "valid"
    # A slow one is ended by the next edit, and does not keep the document open.
    edit(document, "AnchorRadius", "99 mm")
    until(lambda: WORKER.busy, what="the slow one to begin")
    edit(document, "AnchorRadius", "4 mm")
    until(lambda: tiles.Status == design.Anchors.Status == "current")
    assert design.Verdict == "valid" and design.Anchors.Shape.BoundBox.DiagonalLength < 200
    assert 99 not in [radius for _, radius in built], built
    # A run ends one too, which follows after it.
    edit(document, "HBody", "2.6 mm")
    until(lambda: WORKER.busy, what="the next one to begin")
    run.start("verify", design)
    until(lambda: not run.LIVE.busy and design.Verdict == "valid", 60, "the run to end")
    until(lambda: tiles.Status == "current")
    assert built[-1][0] == 2.6, built
    edit(document, "HBody", "2.5 mm")
    until(lambda: WORKER.busy, what="the last one to begin")
    FreeCAD.closeDocument(document.Name)
    until(lambda: not WORKER.busy)


def test_deleting_takes_along_what_is_below(dome_document):
    document, design = opened(dome_document)
    names = {obj.Name for obj in document.Objects}
    copied = document.copyObject(design, False)
    assert {getattr(copied, part).Name for part in PARTS}.isdisjoint(names)
    document.openTransaction("Delete")
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(document.Name, copied.Name)
    FreeCADGui.runCommand("Std_Delete")
    document.commitTransaction()
    settle()
    assert {obj.Name for obj in document.Objects} == names, [obj.Name for obj in document.Objects]
    document.undo()
    settle()
    assert len(document.Objects) == 16 and len(documents.designs(document)) == 2
    again = documents.designs(document)[1]
    assert all(getattr(again, part) is not None for part in PARTS) and again.Verdict == "valid"
    # The target alone: the design says so.
    target = again.Target.Name
    document.openTransaction("Delete the target")
    document.removeObject(target)
    document.recompute()
    document.commitTransaction()
    assert again.Verdict == "out of date" and "deleted" in again.Reasons[0], list(again.Reasons)
    document.undo()
    settle()
    assert again.Verdict == "valid" and again.Target.Name == target, list(again.Reasons)
    # Views came back with their objects.
    assert type(again.ViewObject.Proxy).__name__.endswith("View")
    assert len(again.ViewObject.Proxy.claimChildren()) == 7


def places_in_tree(document, label):
    """Labels on the way from the document's row in the tree down to each row of that label."""
    found = []

    def look(row, way):
        if way[-1:] == [label]:
            found.append(way)
        for child in map(row.child, range(row.childCount())):
            look(child, [*way, child.text(0)])

    for tree in window.findChildren(QtGui.QTreeWidget):
        for row in tree.findItems(document.Label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive):
            look(row, [])
    return found


@pytest.mark.parametrize("kind", [
    "App::Part", pytest.param("App::DocumentObjectGroup", marks=pytest.mark.all)])
def test_a_design_in_a_group_is_deleted_whole_and_comes_back_there(dome_document, kind, pictures):
    document, design = opened(dome_document)
    tidy()
    group = document.addObject(kind, "Mine")
    sheet = document.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "=Verification.TileCount + 1")
    group.addObject(design)
    document.recompute()
    settle()
    labels = sorted(obj.Label for obj in document.Objects)
    others = {obj.Name for obj in document.Objects} - {design.Name, *(getattr(design, p).Name for p in PARTS)}
    before = places_in_tree(document, design.Label), places_in_tree(document, "Tiles")
    assert before == ([["Mine", design.Label]], [["Mine", design.Label, "Tiles"]])
    click_at(tree_entry(design))
    for _ in range(2):
        keys("Delete")
        settle()
        assert {obj.Name for obj in document.Objects} == others
        picture("deleted")
        keys("ctrl+z")
        settle(500)
        picture("undone")
        assert sorted(obj.Label for obj in document.Objects) == labels
        assert (places_in_tree(document, design.Label), places_in_tree(document, "Tiles")) == before
        assert document.Design.Verdict == "valid"
        click_at(tree_entry(document.Design))
