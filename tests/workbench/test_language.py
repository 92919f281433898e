# SPDX-License-Identifier: LGPL-2.1-or-later
"""In a FreeCAD that speaks German menus, tooltips, panels and reasons do so too; preferences."""

import re

import FreeCAD
import FreeCADGui
import pytest
from curveups.features import document as designs
from curveups.features.document import new_design
from curveups.window.commands.command import no_design
from curveups.window.overlays import overlay_of
from curveups.window.panels.export import ExportPanel
from curveups.window.panels.panel import show
from curveups.window.panels.solve import SolvePanel
from robot import (QtCore, QtGui, at_rest, choose, click_at, fill, in_dialog, keys, menu_bar, picture, press,
                   settle, until, widget)
from steps import LIVE, example, opened, panel

pytestmark = pytest.mark.freecad(window=True)


def test_german(tmp_path):
    FreeCADGui.setLocale("German")
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    settle(500)
    action = FreeCADGui.Command.get("CurveUps_Solve").getAction()[0]
    assert action.text() == "Lösen", action.text()
    assert "Kacheln" in action.toolTip(), action.toolTip()
    action = FreeCADGui.Command.get("CurveUps_NewDesign").getAction()[0]
    assert action.text() == "Neuer Entwurf", action.text()
    form = show(SolvePanel, new_design(FreeCAD.newDocument(), "disc")).form
    assert form.stop.text() == "Anhalten" and form.solve.text() == "Lösen", form.stop.text()
    assert form.stages.headerItem().text(0) == "Schritt", form.stages.headerItem().text(0)
    # Parameters, in the panel and as the property editor looks them up; legends.
    form.group.setCurrentIndex(form.group.findText("Kacheln"))
    settle(100)
    tip = form.findChild(QtGui.QWidget, "HBody").toolTip()
    assert tip.startswith("Dicke einer Kachel") and tip.endswith("Wirkt sofort."), tip
    design = FreeCAD.ActiveDocument.Objects[0]
    tip = QtCore.QCoreApplication.translate("App::Property", design.getDocumentationOfProperty("Tau"))
    assert tip.startswith("Dehnung der Membranen"), tip
    designs.take(design, designs.project_of(design).run(("target",)))
    settle(500)
    assert overlay_of(design).legend.content.title == "Faltwinkel"
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    overlay_of(design).set_field("Friction ratio")  # there is none yet: the first one stays
    settle(500)
    FreeCADGui.ActiveDocument.ActiveView.saveImage(str(tmp_path / "german.png"), 900, 600, "White")
    FreeCAD.closeDocument(FreeCAD.ActiveDocument.Name)
    assert no_design().startswith("Es gibt keinen Entwurf"), no_design()


def test_reasons_of_the_solver_are_german(pictures):
    """The native module's among them."""
    FreeCADGui.setLocale("German")
    try:
        made, design = example("mask", L=14, HBody=28)
        press("CurveUps_Check")
        until(lambda: LIVE.busy or panel().form.verdict.text(), 20, "the check")
        at_rest()
        form = panel().form
        picture("check")
        said = [form.verdict.text(), form.advice.text(), *(
            form.obstacles.topLevelItem(row).text(1) for row in range(form.obstacles.topLevelItemCount()))]
        assert len(said) > 3
        verdict = show(SolvePanel, design).form.verdict.text()
        assert "es gibt noch keine Abwicklung" in verdict, verdict
        for text in said:
            assert re.search("Kachel|Rückseite|Zapfen|genügt", text), text
            assert not re.search(r"\b(the|tiles|are|back face|lower|with)\b", text), text
    finally:
        FreeCADGui.setLocale("English")


def test_the_preference_page_keeps_what_panels_show(dome_document, pictures):
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    store = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/CurveUps")

    def change():
        window = QtGui.QApplication.activeModalWidget()
        names = window.findChild(QtGui.QListWidget)
        row = next(row for row in range(names.count()) if names.item(row).text() == "CurveUps")
        names.scrollToItem(names.item(row))
        settle(200)
        click_at(names.viewport().mapToGlobal(names.visualItemRect(names.item(row)).center()))
        box = widget("all_parameters")
        picture("preferences")
        click_at(box.mapToGlobal(QtCore.QPoint(10, box.height() // 2)))
        fill(widget("export_mask"), "{name}_{body}")
        keys("Return")

    try:
        in_dialog(lambda: choose(lambda: menu_bar("Edit"), "Preferences"), change)
        document, design = opened(dome_document)
        form = show(SolvePanel, design).form
        assert form.all.isChecked() and form.findChild(QtGui.QWidget, "Fidelity") is not None
        assert show(ExportPanel, design).form.names.text() == "{name}_{body}"
    finally:
        store.RemBool("AllParameters")
        store.RemString("ExportMask")
