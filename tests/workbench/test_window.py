# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD with a window, on a virtual display: the workbench registers, the document shows as it was
made, and is edited as users do it."""

import os
import re
import struct
import zlib

import FreeCAD
import FreeCADGui
import pytest
from curveups.features import actions, document as documents
from curveups.window.overlays import overlay_of
from robot import settle, until

pytestmark = pytest.mark.freecad(window=True)


def opened(path):
    document = FreeCAD.openDocument(str(path))
    settle()
    return document, FreeCADGui.getDocument(document.Name)


def colour(view):
    """Since FreeCAD 1.0 it is in the appearance."""
    rgb = view.ShapeColor if hasattr(view, "ShapeColor") else view.ShapeAppearance[0].DiffuseColor
    return tuple(rgb[:3])


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
    text = (folder / "dome-print.step").read_text(encoding="utf-8")
    return {tuple(map(float, match)) for match in
            re.findall(r"COLOUR_RGB\('',([\d.E+-]+),([\d.E+-]+),([\d.E+-]+)\)", text)}


def test_document_in_a_window(capfd, dome_document, tmp_path):
    picture, copy = tmp_path / "view.png", str(tmp_path / "copy.FCStd")
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    assert FreeCADGui.activeWorkbench().MenuText == "CurveUps"
    assert os.path.isfile(FreeCADGui.activeWorkbench().Icon)
    document, gui = opened(dome_document)
    view = gui.getObject
    shown = {name: (document.getObject(name).Visibility, view(name).Visibility)
             for name in ("Target", "Tiles", "Support", "Anchors")}
    assert shown == {"Target": (False, False), "Tiles": (True, True), "Support": (False, False),
                     "Anchors": (True, True)}, shown
    assert type(view("Design").Proxy).__name__ == "DesignView"
    assert not view("Design").Proxy.getIcon().isNull()
    assert [child.Name for child in view("Design").Proxy.claimChildren()] == [
        "Target", "Cuts", "Layout", "Verification", "Tiles", "Support", "Anchors"]
    assert view("Tiles").DisplayMode == "Shaded"
    colours = [colour(view(name)) for name in ("Tiles", "Support", "Anchors")]
    view3d = gui.activeView()
    view3d.saveImage(str(picture), 800, 600, "White")
    view("Support").Visibility = True
    view("Tiles").Visibility = False
    document.saveAs(copy)
    FreeCAD.closeDocument(document.Name)
    again = FreeCADGui.getDocument(FreeCAD.openDocument(copy).Name)
    assert again.getObject("Support").Visibility and not again.getObject("Tiles").Visibility
    out = "".join(capfd.readouterr())
    assert "does not support" not in out and "Traceback" not in out, out
    (width, height, depth, _), rows = pixels(picture)
    assert (width, height, depth) == (800, 600, 8)
    # Not blank, without anything having been moved: a picture of tiles does not compress to nothing.
    assert len(zlib.compress(rows)) > 20_000
    expected = step_colours(dome_document.parent)
    assert len(set(colours)) == 3
    for rgb in colours:
        assert any(max(abs(a - b) for a, b in zip(rgb, e)) < 1e-6 for e in expected), (rgb, expected)


def state(document):
    box = document.Tiles.Shape.BoundBox
    return (round(document.Tiles.Shape.Volume, 6), round(box.ZMax, 6), document.Design.Verdict,
            tuple(document.Design.Reasons), round(document.Support.Shape.Volume, 6), document.Tiles.Status)


def followed(document):
    until(lambda: document.Tiles.Status == "current" or document.Design.Status == "invalid",
          what=f"solids ({document.Tiles.Reason}, {document.Design.Reasons})")


def edit(document, name, value):
    """As the property editor does it."""
    document.openTransaction(f"Edit {name}")
    setattr(document.Design, name, value)
    document.recompute()
    document.commitTransaction()


def test_editing_and_undo(dome_document):
    document, gui = opened(dome_document)
    document.UndoMode = 1
    design, before = document.Design, state(document)
    assert before[2] == "valid" and before[5] == "current"
    for name, old, new in (("HBody", 3, "2.5 mm"), ("HPin", 1, "0.8 mm"),
                           ("BumpHeight", 0.25, "0.2 mm")):
        edit(document, name, new)
        # Solids follow the transaction: until then they are what they were, and say so.
        assert document.Tiles.Status == "out of date" and name in document.Tiles.Reason
        assert state(document)[:2] == before[:2] and design.Verdict == "out of date"
        assert any(name in reason for reason in design.Reasons), list(design.Reasons)
        followed(document)
        after = state(document)
        assert all("Up-to-date" in obj.State for obj in document.Objects), name
        assert after[0] != before[0], name
        assert after[2] == "out of date" and name in after[3][0] or after[2] == "not valid", after
        assert document.UndoNames == [f"Edit {name}"], document.UndoNames
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
    for name, value in (("HBody", "45 mm"), ("HPin", "999 mm")):
        edit(document, name, value)
        followed(document)
        assert (design.Status, design.Verdict) == ("invalid", "not valid"), (name, design.Status)
        assert name in design.Reasons[0] and state(document)[:2] == before[:2], list(design.Reasons)
        assert "Up-to-date" in design.State
        document.undo()
        document.recompute()
        followed(document)
        assert state(document) == before, (name, state(document))


def save_a_copy(path, copy):
    """Without the workbench."""
    opened(path)[0].saveAs(str(copy))


def test_it_is_drawn_again_after_a_save_without_the_workbench(elsewhere, tmp_path):
    own, foreign, picture = tmp_path / "own.FCStd", tmp_path / "foreign.FCStd", tmp_path / "view.png"
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    made = FreeCAD.newDocument("Made")
    design = documents.new_design(made, "half-sphere")
    design.L = 14
    actions.solve(design)
    made.recompute()
    made.saveAs(str(own))
    FreeCAD.closeDocument(made.Name)
    elsewhere(save_a_copy, own, foreign, home="nothing", window=True)
    document, gui = opened(foreign)
    settle(800)
    view = gui.getObject("Design")
    assert view.Visibility and view.DisplayMode == "Tiles" and view.SwitchNode.whichChild.getValue() == 0
    gui.activeView().viewTop()
    gui.activeView().fitAll()
    gui.activeView().saveImage(str(picture), 800, 600, "White")
    FreeCADGui.Selection.addSelection(document.Design)
    settle(500)
    command = FreeCADGui.Command.get("CurveUps_ShowActuated")
    assert command.isActive(), command.getAction()[0].statusTip()
    document.Design.Tau = 2.5  # it follows
    document.recompute()
    until(lambda: overlay_of(document.Design).legend.content.faded, 10, "the legend to follow")
    _, rows = pixels(picture)
    assert len(zlib.compress(rows)) > 10_000  # a blank view is a fraction of that
