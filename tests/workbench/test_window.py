# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD with a window, on a virtual display: the workbench registers, the document shows as it was
made, and is edited as users do it."""

import re
import shutil
import struct
import zlib

import pytest
from window import run_in_window

pytestmark = pytest.mark.skipif(not shutil.which("xvfb-run"), reason="there is no xvfb-run")

OPEN = """
def opened():
    document = FreeCAD.openDocument(path)
    settle()
    return document, FreeCADGui.getDocument(document.Name)

def colour(view):
    # Since FreeCAD 1.0 in the appearance.
    rgb = view.ShapeColor if hasattr(view, 'ShapeColor') else view.ShapeAppearance[0].DiffuseColor
    return tuple(rgb[:3])
"""


def pixels(path):
    """The header and the rows of an RGB(A) PNG, without any imaging library."""
    data = path.read_bytes()
    place, rows, header = 8, b"", None
    while place < len(data):
        size, kind = struct.unpack_from(">I4s", data, place)
        body = data[place + 8 : place + 8 + size]
        if kind == b"IHDR":
            header = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            rows += body
        place += 12 + size
    return header, zlib.decompress(rows)


def step_colours(folder):
    """The colours in the print's STEP file, each as three numbers from 0 to 1."""
    text = (folder / "dome-print.step").read_text()
    return {tuple(map(float, match)) for match in
            re.findall(r"COLOUR_RGB\('',([\d.E+-]+),([\d.E+-]+),([\d.E+-]+)\)", text)}


SHOWN = OPEN + """
def work():
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    assert FreeCADGui.activeWorkbench().MenuText == 'CurveUps'
    assert os.path.isfile(FreeCADGui.activeWorkbench().Icon)
    document, gui = opened()
    view = gui.getObject
    shown = {name: (document.getObject(name).Visibility, view(name).Visibility)
             for name in ('Target', 'Tiles', 'Support', 'Anchors')}
    assert shown == {'Target': (False, False), 'Tiles': (True, True), 'Support': (False, False),
                     'Anchors': (True, True)}, shown
    assert type(view('Design').Proxy).__name__ == 'DesignView'
    assert not view('Design').Proxy.getIcon().isNull()
    assert [child.Name for child in view('Design').Proxy.claimChildren()] == [
        'Target', 'Cuts', 'Layout', 'Verification', 'Tiles', 'Support', 'Anchors']
    assert view('Tiles').DisplayMode == 'Shaded'
    with open(colours, 'w') as file:
        for name in ('Tiles', 'Support', 'Anchors'):
            print(*colour(view(name)), file=file)
    view3d = gui.activeView()
    view3d.saveImage(picture, 800, 600, 'White')
    view('Support').Visibility = True
    view('Tiles').Visibility = False
    document.saveAs(copy)
    FreeCAD.closeDocument(document.Name)
    again = FreeCADGui.getDocument(FreeCAD.openDocument(copy).Name)
    assert again.getObject('Support').Visibility and not again.getObject('Tiles').Visibility
"""


def test_document_in_a_window(document, homes, tmp_path):
    picture, colours = tmp_path / "view.png", tmp_path / "colours"
    out = run_in_window(SHOWN, homes[True], tmp_path, path=document, picture=picture,
                        colours=colours, copy=tmp_path / "copy.FCStd")
    assert "does not support" not in out and "Traceback" not in out, out
    (width, height, depth, _), rows = pixels(picture)
    assert (width, height, depth) == (800, 600, 8)
    # Not blank, without anything having been moved: a picture of tiles does not compress to nothing.
    assert len(zlib.compress(rows)) > 20_000
    shown = [tuple(map(float, line.split())) for line in colours.read_text().splitlines()]
    expected = step_colours(document.parent)
    assert len(set(shown)) == 3
    for rgb in shown:
        assert any(max(abs(a - b) for a, b in zip(rgb, e)) < 1e-6 for e in expected), (rgb, expected)


def test_without_the_workbench_it_shows_the_same(document, homes, tmp_path):
    run_in_window(OPEN + """
def work():
    import sys
    assert not any('CurveUps' in p for p in sys.path)
    document, gui = opened()
    shown = {name for name in ('Target', 'Tiles', 'Support', 'Anchors')
             if gui.getObject(name).Visibility}
    assert shown == {'Tiles', 'Anchors'}, shown
    assert colour(gui.getObject('Tiles')) != colour(gui.getObject('Anchors'))
""", homes[False], tmp_path, path=document)


def test_it_is_drawn_again_after_a_save_without_the_workbench(homes, tmp_path):
    own, foreign = tmp_path / "own.FCStd", tmp_path / "foreign.FCStd"
    run_in_window("""
def work():
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    from curveups.features import actions, document as documents
    made = FreeCAD.newDocument('Made')
    design = documents.new_design(made, 'half-sphere')
    design.L = 14
    actions.solve(design)
    made.recompute()
    made.saveAs(path)
""", homes[True], tmp_path, path=own)
    run_in_window(OPEN + """
def work():
    opened()[0].saveAs(copy)
""", homes[False], tmp_path, path=own, copy=foreign)
    run_in_window(OPEN + """
def work():
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    document, gui = opened()
    settle(800)
    view = gui.getObject('Design')
    assert view.Visibility and view.DisplayMode == 'Tiles' and view.SwitchNode.whichChild.getValue() == 0
    gui.activeView().viewTop()
    gui.activeView().fitAll()
    gui.activeView().saveImage(picture, 800, 600, 'White')
    FreeCADGui.Selection.addSelection(document.Design)
    settle(500)
    command = FreeCADGui.Command.get('CurveUps_ShowActuated')
    assert command.isActive(), command.getAction()[0].statusTip()
    document.Design.Tau = 2.5  # it follows
    document.recompute()
    settle(500)
    from curveups.window.overlays import overlay_of
    assert overlay_of(document.Design).legend.content.faded
""", homes[True], tmp_path, path=foreign, picture=tmp_path / "view.png")
    _, rows = pixels(tmp_path / "view.png")
    assert len(zlib.compress(rows)) > 10_000  # a blank view is a fraction of that


EDITED = OPEN + """
def state(document):
    box = document.Tiles.Shape.BoundBox
    return (round(document.Tiles.Shape.Volume, 6), round(box.ZMax, 6), document.Design.Verdict,
            tuple(document.Design.Reasons), round(document.Support.Shape.Volume, 6), document.Tiles.Status)

def followed(document):
    for _ in range(100):
        settle(100)
        if document.Tiles.Status == 'current' or document.Design.Status == 'invalid':
            return
    raise AssertionError((document.Tiles.Reason, document.Design.Reasons))

def edit(document, name, value):
    # As the property editor does it.
    document.openTransaction(f'Edit {name}')
    setattr(document.Design, name, value)
    document.recompute()
    document.commitTransaction()

def work():
    document, gui = opened()
    document.UndoMode = 1
    design, before = document.Design, state(document)
    assert before[2] == 'valid' and before[5] == 'current'
    for name, old, new in (('HBody', 3, '2.5 mm'), ('HPin', 1, '0.8 mm'),
                           ('BumpHeight', 0.25, '0.2 mm')):
        edit(document, name, new)
        # Solids follow the transaction: until then they are what they were, and say so.
        assert document.Tiles.Status == 'out of date' and name in document.Tiles.Reason
        assert state(document)[:2] == before[:2] and design.Verdict == 'out of date'
        assert any(name in reason for reason in design.Reasons), list(design.Reasons)
        followed(document)
        after = state(document)
        assert all('Up-to-date' in obj.State for obj in document.Objects), name
        assert after[0] != before[0], name
        assert after[2] == 'out of date' and name in after[3][0] or after[2] == 'not valid', after
        assert document.UndoNames == [f'Edit {name}'], document.UndoNames
        document.undo()
        assert getattr(design, name).Value == old, name
        followed(document)
        assert state(document) == before, (name, state(document), before)
        document.recompute()
        assert state(document) == before, name
        document.redo()
        followed(document)
        assert state(document) == after, name
        document.undo()
        followed(document)
    # Impossible: shapes stay, the design says why, undo makes it whole again.
    for name, value in (('HBody', '45 mm'), ('HPin', '999 mm')):
        edit(document, name, value)
        followed(document)
        assert (design.Status, design.Verdict) == ('invalid', 'not valid'), (name, design.Status)
        assert name in design.Reasons[0] and state(document)[:2] == before[:2], list(design.Reasons)
        assert 'Up-to-date' in design.State
        document.undo()
        document.recompute()
        followed(document)
        assert state(document) == before, (name, state(document))
"""


def test_editing_and_undo(document, homes, tmp_path):
    out = run_in_window(EDITED, homes[True], tmp_path, path=document)
    assert "Traceback" not in out, out
