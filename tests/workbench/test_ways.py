# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command in every way that a user has to it, by the mouse: toolbar, menu, context menus of tree and
view."""

import os

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from curveups.features import document as designs
from curveups.window import commands, qt
from curveups.window.overlay import cameras
from robot import (QtCore, QtGui, at_rest, choose, click, click_at, in_dialog, keys, menu_bar, menu_of,
                   on_screen, picture, press, report, settle, tree_entry, until, widget, window)
from steps import LIVE, begin, click_edge, edge_at, leave, opened, panel, point_in

pytestmark = pytest.mark.freecad(window=True, timeout=600)


def entry(name):
    """What a command is called in menus."""
    return qt.translate(name, FreeCADGui.Command.get(name).getInfo()["menuText"]).replace("&", "")


def check(name, start, design, pages):
    """start() is the user's way to the command; then what it is for has happened."""
    made, short = design.Document, name.split("_")[1]
    until(lambda: FreeCADGui.Command.get(name).isActive(), 10, name)
    undos = list(made.UndoNames)
    if short in ("NewDesign", "Target"):
        FreeCADGui.Selection.clearSelection()
        in_dialog(start, lambda: keys("Escape"))
        assert list(made.UndoNames) == undos
        return
    documents = FreeCAD.listDocuments()
    start()
    if short in ("Solve", "Verify", "Repair", "BuildSolids"):
        until(lambda: panel() is not None, 10, f"{name} to begin")
        at_rest()
        assert panel().design == design and "valid" in panel().form.verdict.text()
        if short != "BuildSolids":
            assert list(made.UndoNames)[0] == short, (name, made.UndoNames)
    elif short == "Actuate":
        until(lambda: panel() is not None, 10, f"{name} to begin")
        at_rest()
        assert design.Actuation == "current" and panel().form.verdict.text()
    elif short in ("Check", "Cuts", "Overlay", "WorstContacts", "Export", "Kit"):
        until(FreeCADGui.Control.activeDialog, 10, f"the panel of {name}")
    elif short == "ShowSolids":
        until(lambda: design.Tiles.Visibility and not design.Visibility, 20, "solids")
    elif short in ("ShowFlat", "ShowActuated"):
        until(lambda: design.Visibility and not design.Tiles.Visibility, 10, "the overlay")
        until(lambda: design.ViewObject.Morph == (short == "ShowActuated"), 10, name)
    elif short == "Report":
        until(lambda: pages, 120, "the page")
        assert os.path.getsize(pages.pop()) > 50000
    elif short == "Example":
        until(lambda: len(FreeCAD.listDocuments()) == len(documents) + 1, 10, "a document")
        other = FreeCAD.ActiveDocument
        assert other.Label == entry(name), other.Label
        until(lambda: panel() is not None, 10, "the example to be solved")
        LIVE.cancel()
        leave()
        FreeCAD.closeDocument(other.Name)
        FreeCADGui.ActiveDocument = FreeCADGui.getDocument(made.Name)
        FreeCAD.setActiveDocument(made.Name)
    elif short == "Guide":
        widget("CurveUpsGuide").close()
    elif short == "SolverStatus":
        widget("CurveUpsSolverStatus").close()
    else:
        raise AssertionError(f"{name}: say here what it does")
    leave()
    assert "Traceback" not in report() and "unexpected" not in report(), (name, report())


def entries(menu, before=()):
    """Texts on the way to each entry of a menu and of those below it."""
    for one in menu.actions():
        text = one.text().replace("&", "")
        below = menu_of(one)
        if below is not None:
            yield from entries(below, (*before, text))
        elif not one.isSeparator():
            yield (*before, text)


@pytest.fixture
def pages(monkeypatch):
    """Paths of pages that were opened."""
    found = []
    monkeypatch.setattr(qt.QtGui.QDesktopServices, "openUrl", lambda url: found.append(url.toLocalFile()))
    return found


@pytest.fixture
def prepared(dome_document, tmp_path):
    """A design with solids, in a saved document. The view shows its tiles."""
    document, design = opened(dome_document)
    document.saveAs(str(tmp_path / "saved.FCStd"))
    FreeCADGui.runCommand("CurveUps_ShowActuated")
    until(lambda: design.Visibility and design.ViewObject.Morph == 1, 10, "the tiles")
    return design


@pytest.fixture
def known(prepared):
    """Commands by what they are called in menus, without the menu of examples."""
    return {entry(name): name for name in FreeCADGui.listCommands()
            if name.startswith("CurveUps_") and name != "CurveUps_Examples"}


def test_every_entry_of_the_menu(prepared, known, pages):
    menu = next(one for one in window.menuBar().findChildren(QtGui.QMenu)
                if one.menuAction().text().replace("&", "") == "CurveUps")
    ways = list(entries(menu))
    assert {way[-1] for way in ways} == set(known), (ways, known)
    for way in sorted(ways, key=lambda way: "_Example_" in known[way[-1]]):
        check(known[way[-1]], lambda: choose(lambda: menu_bar("CurveUps"), *way), prepared, pages)


def test_every_button_of_the_toolbar(prepared, known, pages):
    bars = [one for one in window.findChildren(QtGui.QToolBar) if one.windowTitle().startswith("CurveUps")]
    buttons = [one for bar in bars for one in bar.findChildren(QtGui.QToolButton)
               if one.isVisible() and one.defaultAction()]
    assert buttons
    for button in buttons:
        text = button.defaultAction().text().replace("&", "")
        check(known[text], lambda: click(button), prepared, pages)


def test_every_entry_of_the_menus_in_the_tree(prepared, pages):
    """Each command by the first object that offers it; of others one entry."""
    tried: set[str] = set()
    for obj in [prepared, *prepared.ViewObject.Proxy.claimChildren()]:
        menu = obj.ViewObject.Proxy.MENU
        names = [name for name in menu if name not in tried] or menu[:1]
        tried.update(names)
        for name in names:
            settle(500)  # the tree comes back after a panel
            check(name, lambda: choose(lambda: click_at(tree_entry(obj), 3), entry(name)), prepared, pages)


def test_every_entry_of_the_menu_of_the_view(prepared, pages):
    names = commands.for_view()
    assert {"CurveUps_Solve", "CurveUps_Cuts", "CurveUps_Export", "CurveUps_ShowFlat"} <= set(names), names
    area = window.findChild(QtGui.QMdiArea)
    for name in names:
        corner = area.mapToGlobal(QtCore.QPoint(area.width() - 60, area.height() - 60))
        check(name, lambda: choose(lambda: click_at(corner, 3), "CurveUps", entry(name)), prepared, pages)


def test_cuts_by_the_menu_over_a_tile_and_in_a_new_view(prepared, pictures):
    """The tools that take the mouse begin in the middle of the click that opened the menu."""
    FreeCADGui.runCommand("Std_ViewCreate")
    settle(500)
    for view in (FreeCADGui.ActiveDocument.ActiveView, None):
        if view is None:  # of the document from its beginning
            window.findChild(QtGui.QMdiArea).activatePreviousSubWindow()
            settle(300)
        view = FreeCADGui.ActiveDocument.ActiveView
        view.viewTop()
        view.fitAll()
        settle(500)
        pair, places = edge_at(prepared, 5, 5)
        middle = on_screen(point_in(prepared, pair))
        choose(lambda: click_at(middle, 3), "CurveUps", "Cuts")
        until(lambda: type(panel()).__name__ == "CutsPanel", 20, "the panel")
        at_rest()
        picture("chosen")
        assert click_edge(prepared, 5, 5) == pair
        assert designs.cuts_of(prepared).tolist() == [list(pair)]
        at_rest()
        prepared.Document.undo()
        leave()
        assert not len(designs.cuts_of(prepared))


def look():
    """Where the view looks."""
    return np.array(cameras.aim(FreeCADGui.ActiveDocument.ActiveView))


def shown(part):
    return part.Visibility and part.ViewObject.Visibility


@pytest.mark.parametrize("kind", ["solid", "face", "mesh"])
def test_the_first_layout_of_ones_own_part_comes_into_view(kind, pictures):
    import MeshPart
    import Part

    made = begin()
    solid = Part.makeSphere(40, FreeCAD.Vector(300, 0, 0), FreeCAD.Vector(0, 0, 1), 35)
    face = max(solid.Faces, key=lambda one: one.Area)
    part = made.addObject("Mesh::Feature" if kind == "mesh" else "Part::Feature", "Cap")
    if kind == "mesh":
        part.Mesh = MeshPart.meshFromShape(Shape=face, LinearDeflection=0.05, AngularDeflection=0.1)
    else:
        part.Shape = solid if kind == "solid" else face
    made.recompute()
    FreeCADGui.Selection.addSelection(part)
    press("CurveUps_NewDesign")
    design = made.Design
    design.L = 4
    made.recompute()
    camera = look()
    # A run that is cancelled leaves all as it was. Such small tiles take longer than the way to the button.
    press("CurveUps_Solve")
    until(lambda: LIVE._drawn, 300, "a picture of the run")
    assert not shown(part)
    click(panel().form.cancel)
    at_rest()
    assert shown(part) and np.allclose(look(), camera, atol=1e-3)
    design.L = 12
    made.recompute()
    click(panel().form.solve)
    at_rest()
    assert design.TileCount and not shown(part)
    assert picture(f"{kind}-solved") > 20
    assert not np.allclose(look(), camera, atol=1)
    # Only the first one: what the user shows again, and where the user looks, stays.
    part.Visibility = True
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    looked = look()
    click(panel().form.solve)
    at_rest()
    assert shown(part) and np.allclose(look(), looked, atol=1e-3)
    part.Visibility = False
    for _ in range(2):
        keys("ctrl+z")
        settle(500)
    assert design.TileCount == 0 and shown(part), made.UndoNames
    assert np.allclose(look(), camera, atol=1e-3)
    keys("ctrl+shift+z")
    until(lambda: design.TileCount and not shown(part), 10, "the layout again")
