# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command in every way that a user has to it, by the mouse: toolbar, menu, context menus of the
tree."""

import os

import FreeCAD
import FreeCADGui
import pytest
from curveups.window import qt
from robot import (QtGui, at_rest, choose, click, click_at, in_dialog, keys, menu_bar, menu_of, picture,
                   press, report, settle, tree_entry, until, widget, window)
from steps import LIVE, begin, leave, opened, panel

pytestmark = [pytest.mark.freecad(window=True, timeout=600), pytest.mark.all]


def entry(name):
    """Name of a command in menus."""
    return qt.translate(name, FreeCADGui.Command.get(name).getInfo()["menuText"]).replace("&", "")


def check(name, start, design, pages):
    """start() is the user's way to the command; then what it is for has happened."""
    document, short = design.Document, name.split("_")[1]
    until(lambda: FreeCADGui.Command.get(name).isActive(), 10, name)
    undos = list(document.UndoNames)
    if short in ("NewDesign", "Target"):
        FreeCADGui.Selection.clearSelection()
        in_dialog(start, lambda: keys("Escape"))
        assert list(document.UndoNames) == undos
        return
    documents = FreeCAD.listDocuments()
    start()
    if short in ("Solve", "Verify", "Repair", "BuildSolids"):
        until(lambda: panel() is not None, 10, f"{name} to begin")
        at_rest()
        assert panel().design == design and "valid" in panel().form.verdict.text()
        if short != "BuildSolids":
            assert list(document.UndoNames)[0] == short, (name, document.UndoNames)
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
        FreeCADGui.ActiveDocument = FreeCADGui.getDocument(document.Name)
        FreeCAD.setActiveDocument(document.Name)
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
    """Commands by their texts in menus."""
    return {entry(name): name for name in FreeCADGui.listCommands() if name.startswith("CurveUps_")}


def test_every_entry_of_the_menu(prepared, known, pages):
    menu = next(one for one in window.menuBar().findChildren(QtGui.QMenu)
                if one.menuAction().text().replace("&", "") == "CurveUps")
    ways = list(entries(menu))
    assert {way[-1] for way in ways} == set(known), (ways, known)
    for way in sorted(ways, key=lambda way: "_Example_" in known[way[-1]]):
        check(known[way[-1]], lambda: choose(lambda: menu_bar("CurveUps"), *way), prepared, pages)


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


def shown(part):
    return part.Visibility and part.ViewObject.Visibility


def test_the_first_layout_of_ones_own_part_takes_its_place(pictures):
    import Part

    document = begin()
    part = document.addObject("Part::Feature", "Cap")
    part.Shape = Part.makeSphere(40, FreeCAD.Vector(300, 0, 0), FreeCAD.Vector(0, 0, 1), 35)
    document.recompute()
    FreeCADGui.Selection.addSelection(part)
    press("CurveUps_NewDesign")
    design = document.Design
    design.L = 12
    document.recompute()
    press("CurveUps_Solve")
    at_rest()
    assert design.TileCount and not shown(part)
    assert picture("solved") > 20
    # Only the first one: what the user shows again stays.
    part.Visibility = True
    click(panel().form.solve)
    at_rest()
    assert shown(part)
    part.Visibility = False
    for _ in range(2):
        keys("ctrl+z")
        settle(500)
    assert design.TileCount == 0 and shown(part), document.UndoNames
