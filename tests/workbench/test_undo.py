# SPDX-License-Identifier: LGPL-2.1-or-later
"""In a window: what transactions hold, solids that follow them and can be ended, deleting and copying."""

import shutil

import pytest
from window import run_in_window

pytestmark = pytest.mark.skipif(not shutil.which("xvfb-run"), reason="there is no xvfb-run")

OPEN = """
import time
from curveups.features import document as documents

PARTS = ('Target', 'Cuts', 'Layout', 'Verification', 'Tiles', 'Support', 'Anchors')

def opened():
    document = FreeCAD.openDocument(path)
    document.UndoMode = 1
    settle()
    return document, document.Design

def until(condition, seconds=60):
    start = time.time()
    while not condition():
        assert time.time() - start < seconds
        settle(20)

def edit(document, name, value):
    document.openTransaction(f'Edit {name}')
    setattr(document.Design, name, value)
    document.recompute()
    document.commitTransaction()
"""

FOLLOWS = OPEN + """
def work():
    from curveups.window.viewproviders import following
    document, design = opened()
    tiles, size = design.Tiles, document.UndoRedoMemSize
    # Edits in quick succession: solids are built for the last one alone.
    built = []
    real = following.rebuild.take
    following.rebuild.take = lambda obj, results: (built.append(obj.HBody.Value), real(obj, results))
    for thickness in (2.9, 2.8, 2.7):
        edit(document, 'HBody', f'{thickness} mm')
        assert tiles.Status == 'out of date'
    until(lambda: tiles.Status == 'current')
    assert built == [2.7] and abs(tiles.Shape.BoundBox.ZLength - 4.7) < 1e-6, built
    # No shapes in what can be undone, and following is no step of its own.
    assert document.UndoRedoMemSize - size < 2e5, document.UndoRedoMemSize
    assert document.UndoNames == ['Edit HBody'] * 3
    start = time.time()
    for _ in range(3):
        document.undo()
    assert time.time() - start < 0.3
    assert design.HBody.Value == 3 and design.Verdict == 'valid' and tiles.Status == 'out of date'
    until(lambda: tiles.Status == 'current')
    assert abs(tiles.Shape.BoundBox.ZLength - 5) < 1e-6
    # Nothing is built inside of an open transaction.
    document.openTransaction('Long')
    design.HPin = '0.9 mm'
    document.recompute()
    settle(1500)
    assert tiles.Status == 'out of date'
    document.abortTransaction()
    settle(500)
    assert design.HPin.Value == 1 and tiles.Status == 'current' and design.Verdict == 'valid'
    # A slow one is ended by the next edit, and does not keep the document open.
    edit(document, 'AnchorDistance', '199 mm')
    settle(600)
    start = time.time()
    edit(document, 'AnchorDistance', '3 mm')
    assert time.time() - start < 1
    until(lambda: tiles.Status == design.Anchors.Status == 'current')
    assert design.Verdict == 'valid' and design.Anchors.Shape.BoundBox.DiagonalLength < 200
    edit(document, 'HBody', '2.5 mm')
    settle(300)
    FreeCAD.closeDocument(document.Name)
    settle(1000)
"""


def test_solids_follow_transactions(document, homes, tmp_path):
    out = run_in_window(FOLLOWS, homes[True], tmp_path, path=document)
    assert "Traceback" not in out, out


DELETED = OPEN + """
def work():
    document, design = opened()
    names = {obj.Name for obj in document.Objects}
    copied = document.copyObject(design, False)
    assert {getattr(copied, part).Name for part in PARTS}.isdisjoint(names)
    document.openTransaction('Delete')
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(document.Name, copied.Name)
    FreeCADGui.runCommand('Std_Delete')
    document.commitTransaction()
    settle()
    assert {obj.Name for obj in document.Objects} == names, [obj.Name for obj in document.Objects]
    document.undo()
    settle()
    assert len(document.Objects) == 16 and len(documents.designs(document)) == 2
    again = documents.designs(document)[1]
    assert all(getattr(again, part) is not None for part in PARTS) and again.Verdict == 'valid'
    # The target alone: the design says so.
    target = again.Target.Name
    document.openTransaction('Delete the target')
    document.removeObject(target)
    document.commitTransaction()
    assert again.Verdict == 'out of date' and 'deleted' in again.Reasons[0], list(again.Reasons)
    document.undo()
    settle()
    assert again.Verdict == 'valid' and again.Target.Name == target, list(again.Reasons)
    # Views came back with their objects.
    assert type(again.ViewObject.Proxy).__name__.endswith('View')
    assert len(again.ViewObject.Proxy.claimChildren()) == 7
"""


def test_deleting_takes_along_what_is_below(document, homes, tmp_path):
    out = run_in_window(DELETED, homes[True], tmp_path, path=document)
    assert "Traceback" not in out, out


FOREIGN = OPEN + """
def work():
    document, design = opened()
    assert type(design.Proxy).__name__ == 'DesignProxy'
    assert type(design.ViewObject.Proxy).__name__.endswith('View')
    assert design.Verdict == 'valid'
    assert not document.Support.ViewObject.Visibility and document.Tiles.ViewObject.Visibility
    edit(document, 'HBody', '2.5 mm')
    until(lambda: document.Tiles.Status == 'current')
    # Again what opening did, by the command: nothing is left to do.
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    design.Proxy = design.ViewObject.Proxy = None
    FreeCADGui.runCommand('CurveUps_RestoreObjects')
    assert type(design.Proxy).__name__ == 'DesignProxy'
    assert type(design.ViewObject.Proxy).__name__.endswith('View')
    edit(document, 'HBody', '3 mm')
    until(lambda: document.Tiles.Status == 'current')
    assert design.Verdict == 'valid', list(design.Reasons)
"""


def test_saved_in_a_window_without_the_workbench(document, homes, tmp_path):
    copy = tmp_path / "foreign.FCStd"
    run_in_window("""
def work():
    document = FreeCAD.openDocument(path)
    settle()
    document.saveAs(copy)
""", homes[False], tmp_path, path=document, copy=copy)
    out = run_in_window(FOREIGN, homes[True], tmp_path, path=copy)
    assert "Traceback" not in out, out
