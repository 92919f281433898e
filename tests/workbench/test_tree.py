# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Design and the objects below it in the tree: badges, menus, double clicks."""

import FreeCAD
import FreeCADGui
import pytest
import steps
from curveups.window.overlays import overlay_of
from curveups.window.viewproviders import ShapeView
from robot import QtGui, choose, close_panel, menu_bar, picture, press, settle, until
from steps import LIVE, panel

pytestmark = pytest.mark.freecad(window=True)


PARTS = ("Target", "Cuts", "Layout", "Verification", "Tiles", "Support", "Anchors")
SHAPES = ("Target", "Tiles", "Support", "Anchors")


def opened(path):
    document = FreeCAD.openDocument(str(path))
    settle()
    return document, FreeCADGui.getDocument(document.Name)


def shown(gui):
    return {name for name in SHAPES if gui.getObject(name).Visibility}


def drawn(gui):
    """Icons in the tree, by name."""
    images = {}
    for name in ("Design", *PARTS):
        proxy = gui.getObject(name).Proxy
        image = proxy.getIcon().pixmap(64, 64).toImage()
        images[name] = bytes(image.constBits())[:image.sizeInBytes()]
    return images


def test_all_below_a_design_is_a_full_member_of_the_tree(dome_document, tmp_path):
    out = str(tmp_path / "again.FCStd")
    document, gui = opened(dome_document)
    document.UndoMode = 1
    design = document.Design
    current = drawn(gui)
    assert len({current[name] for name in SHAPES}) == 4
    # A state is a badge, there and back.
    for name, value, changed in (("HBody", "2.9 mm", {"Tiles", "Support", "Anchors"}),
                                 ("L", "9 mm", {"Target", "Layout"})):
        document.openTransaction("Edit")
        setattr(design, name, value)
        document.recompute()
        document.commitTransaction()
        now = drawn(gui)
        assert changed < {part for part in PARTS if now[part] != current[part]}, name
        document.undo()
        assert drawn(gui) == current, name
    # Every menu has commands, in a session that never activated the workbench too.
    for name in ("Design", *PARTS):
        menu = QtGui.QMenu()
        gui.getObject(name).Proxy.setupContextMenu(gui.getObject(name), menu)
        assert menu.actions() and all(action.text() for action in menu.actions()), name
    # A double click opens the panel, at what made the object; nothing is run by it.
    for name, group in (("Target", "Target"), ("Layout", "Layout"), ("Verification", "Physics"),
                        ("Tiles", "Tiles"), ("Support", "Support"), ("Anchors", "Anchors")):
        assert gui.getObject(name).Proxy.doubleClicked(gui.getObject(name))
        settle(100)
        assert panel() is not None and panel().design == design, name
        assert panel().form.group.currentText() == group, (name, panel().form.group.currentText())
        assert not LIVE.busy
    panel().reject()
    settle(200)
    # Undone deletions, copies and reopened documents have their views.
    FreeCADGui.Selection.addSelection(document.Name, "Design")
    FreeCADGui.runCommand("Std_Delete")
    settle()
    assert not document.Objects
    document.undo()
    settle()
    copy = document.copyObject(document.Design, True)
    for one in (document.Design, copy):
        assert all(isinstance(getattr(one, slot).ViewObject.Proxy, ShapeView) for slot in SHAPES), one.Name
    copied = copy.Name
    before = shown(gui)
    document.saveAs(out)
    FreeCAD.closeDocument(document.Name)
    document, gui = opened(out)
    assert shown(gui) == before == {"Tiles", "Anchors"}, (shown(gui), before)
    for one in (document.Design, document.getObject(copied)):
        assert all(isinstance(getattr(one, slot).ViewObject.Proxy, ShapeView) for slot in SHAPES), one.Name
    assert drawn(gui) == current
    assert not gui.Modified, "opening is no edit"


def test_a_document_of_the_command_line_shows_solids_alone_until_asked(dome_document, pictures):
    document, design = steps.opened(dome_document)
    assert not document.Support.ViewObject.Visibility
    assert not design.ViewObject.Visibility and document.Tiles.ViewObject.Visibility
    assert overlay_of(design).scene is None
    picture("solids")
    press("CurveUps_WorstContacts")  # which needs what the overlay draws
    until(lambda: panel().form.rows.rowCount() > 3, 10, "contacts")
    close_panel()
    choose(lambda: menu_bar("CurveUps"), "Show", "Show Actuated")
    until(lambda: design.ViewObject.Visibility and not document.Tiles.ViewObject.Visibility, 10, "tiles")
    until(lambda: design.ViewObject.Morph == 1, 10, "the shape")
    assert picture("overlay") > 20
