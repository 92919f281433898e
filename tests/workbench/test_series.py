# SPDX-License-Identifier: LGPL-2.1-or-later
"""A newcomer's first session in a fresh profile, by the mouse and the keys: from an example, a solid or an
STL file to print files. Each step is a picture in build/series. One session runs by default;
CURVEUPS_SERIES=all runs every beginning in every language, theme, schema of units and display."""

import itertools
import os
import re
import shutil

import FreeCAD
import FreeCADGui
import Mesh
import pytest
from curveups.features.document import designs
from curveups.window.overlays import overlay_of
from curveups.window.qt import translate
from robot import (QtCore, QtGui, choose, choose_file, click, click_at, close_panel, cut_off, display, fill,
                   in_dialog, keep_pictures_in, keys, menu_bar, on_screen, picture, press, report, settle,
                   texts, tree_entry, until, widget, window)
from running import ROOT, dome
from steps import ENGLISH, LIVE, panel

pytestmark = [pytest.mark.freecad(window=True, timeout=600), pytest.mark.all]
BEGINNINGS = ("half-sphere", "solid", "stl")
SURROUNDINGS = ("", "german", "dark", "inch", "4K", "4K german dark inch")
ALL = os.environ.get("CURVEUPS_SERIES") == "all"


def sessions():
    """What a session begins with, and its surroundings: the display and what the profile has chosen."""
    every = itertools.product(SURROUNDINGS, BEGINNINGS)
    for around, begin in every if ALL else [("german dark inch", "stl")]:
        window = "4K" if "4K" in around else True
        home = around.replace("4K", "").strip() or "workbench"
        yield pytest.param(begin, around, marks=pytest.mark.freecad(window=window, home=home))


class Session:
    """Its pictures, and what holds in each of them."""

    def __init__(self, begin, around):
        self._around, self._count = around, 0
        self.folder = ROOT / "build" / "series" / f"{begin} {around}".strip()
        shutil.rmtree(self.folder, ignore_errors=True)
        keep_pictures_in(self.folder)

    def shot(self, name):
        self._count += 1
        return picture(f"{self._count:02}-{name}")

    def panel(self, name, colours=12):
        """The panel is seen whole, in the user's language and units, beside a picture of the design."""
        seen, form = self.shot(name), panel().form
        assert seen >= colours, (name, seen)
        assert not cut_off(form), (name, cut_off(form))
        legend = overlay_of(panel().design).legend.content
        said = [*texts(form), legend.title_line, *legend.notes, *(text for _, text in legend.marks)]
        if "german" in self._around:
            assert not [text for text in said if ENGLISH.search(text)], (name, said)
        metric = [text for text in said if re.search(r"\b[mcµ]m(\b|[23²³])", text)]
        assert not metric if "inch" in self._around else metric, (name, metric, said)


def from_half_sphere(session, folder):
    session.shot("start")
    choose(lambda: menu_bar("CurveUps"), translate("CurveUps_Examples", "Examples"), "Half-Sphere")


def from_stl(session, folder):
    (folder / "bowl.obj").write_text(dome(4))
    bowl = Mesh.Mesh(str(folder / "bowl.obj"))
    bowl.flipNormals()
    bowl.write(str(folder / "bowl.stl"))
    in_dialog(lambda: keys("ctrl+o"), lambda: choose_file(str(folder / "bowl.stl")))
    until(lambda: FreeCAD.ActiveDocument and FreeCAD.ActiveDocument.Objects, 30, "the mesh")
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    settle(500)
    mesh = FreeCAD.ActiveDocument.Objects[0].Mesh
    click_at(on_screen(mesh.Facets[0].InCircle[0]))
    session.shot("opened")
    designed_and_checked(session)


def from_solid(session, folder):
    """A bowl with a wall of 3 mm, modelled in Part."""
    document = FreeCAD.newDocument("Part")
    balls = [document.addObject("Part::Sphere", name) for name in ("Outside", "Inside")]
    for ball, radius in zip(balls, (45, 42)):
        ball.Radius, ball.Angle1, ball.Angle2 = radius, -90, -30
    bowl = document.addObject("Part::Cut", "Bowl")
    bowl.Base, bowl.Tool = balls
    document.recompute()
    for ball in balls:
        ball.Visibility = False
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    settle(500)
    click_at(tree_entry(bowl))
    session.shot("modelled")
    designed_and_checked(session)


def designed_and_checked(session):
    assert len(FreeCADGui.Selection.getSelection()) == 1
    press("CurveUps_NewDesign")
    until(lambda: designs(FreeCAD.ActiveDocument), 20, "the design")
    press("CurveUps_Check")
    at_rest()
    session.panel("checked")
    assert re.search(">Feasible<|>Machbar<", panel().form.verdict.text()), panel().form.verdict.text()
    press("CurveUps_Solve")


def at_rest():
    until(lambda: panel() is not None, 30, "the panel")
    until(lambda: not LIVE.busy, 200, "the run to end")
    settle(500)


def folded(session, design):
    press("CurveUps_Overlay")
    slider, overlay = widget("morph"), overlay_of(design)
    option = QtGui.QStyleOptionSlider()
    slider.initStyleOption(option)
    handle = slider.style().subControlRect(QtGui.QStyle.CC_Slider, option, QtGui.QStyle.SC_SliderHandle,
                                           slider)
    first, middle = map(slider.mapToGlobal, (handle.center(), slider.rect().center()))
    display("mousemove", first.x(), first.y(), "mousedown", 1)
    display("mousemove", middle.x(), middle.y())
    session.panel("folding")
    assert 0.3 < overlay.morph() < 0.7, overlay.morph()
    display("mousemove", middle.x() + slider.width(), middle.y(), "mouseup", 1)  # the end stops it
    until(lambda: overlay.morph() == 1, 10, "the shape")
    session.panel("folded")


@pytest.mark.parametrize("begin, around", list(sessions()))
def test_a_first_session_ends_with_print_files(begin, around, tmp_path):
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    window.move(0, 0)
    window.resize(QtGui.QApplication.primaryScreen().size() if "4K" in around else QtCore.QSize(1200, 760))
    settle(500)
    session = Session(begin, around)
    {"half-sphere": from_half_sphere, "solid": from_solid, "stl": from_stl}[begin](session, tmp_path)
    design = until(lambda: next((one for one in designs(FreeCAD.ActiveDocument) if one.TileCount), None), 200,
                   "a layout")
    at_rest()
    session.panel("solved")
    assert (design.Verdict, design.Holds) == ("valid", "holds"), list(design.Reasons)
    said = panel().form.verdict.text()
    assert ("gültig, hält" if "german" in around else "valid, holds") in said, said
    folded(session, design)
    press("CurveUps_Export")
    fill(widget("folder"), str(tmp_path / "files"))
    session.panel("export")
    click(widget("write"))
    until(lambda: LIVE.busy or (tmp_path / "files").is_dir(), 20, "the export to begin")
    at_rest()
    session.panel("exported")
    close_panel()
    session.shot("end")
    names = {path.name for path in (tmp_path / "files").iterdir()}
    assert {"report.html", "report.json"} < names, names
    assert {one.rpartition("-print")[2] for one in names if "-print" in one} == {".3mf", ".step"}, names
    assert "Traceback" not in report() and "unexpected" not in report(), report()[-2000:]
