# SPDX-License-Identifier: LGPL-2.1-or-later
"""In a FreeCAD that speaks German menus, tooltips, panels and reasons do so too; preferences."""

import FreeCAD
import FreeCADGui
import pytest
from curveups.features import document as designs
from curveups.features.document import new_design
from curveups.window.commands import menus
from curveups.window.export import ExportPanel
from curveups.window.overlays import no_design, overlay_of
from curveups.window.panel import show
from curveups.window.solve import SolvePanel
from robot import (QtCore, QtGui, action, choose, choose_file, click, click_at, entry_of, fill, in_dialog,
                   keys, menu_bar, menu_of, picture, press, settle, until, widget, window)
from steps import ENGLISH, LIVE, example, opened, panel

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
    assert tip.startswith("Dicke einer Kachel") and tip.endswith("Wirkt sofort.\n= 3.00 mm"), tip
    design = FreeCAD.ActiveDocument.Objects[0]
    tip = QtCore.QCoreApplication.translate("App::Property", design.getDocumentationOfProperty("Tau"))
    assert tip.startswith("Dehnung der Membranen"), tip
    designs.take(design, designs.project_of(design).run(("target",)))
    settle(500)
    assert overlay_of(design).legend.content.title == "Diederwinkel"
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    overlay_of(design).set_field("Friction ratio")  # there is none yet: the first one stays
    settle(500)
    FreeCADGui.ActiveDocument.ActiveView.saveImage(str(tmp_path / "german.png"), 900, 600, "White")
    FreeCAD.closeDocument(FreeCAD.ActiveDocument.Name)
    assert no_design().startswith("Es gibt keinen Entwurf"), no_design()


def menu_texts():
    """Entries of the menu CurveUps, with the titles of menus below it."""
    top = next(entry for entry in window.menuBar().actions() if entry.text() == "&CurveUps")
    return [entry.text().replace("&", "") for entry in menu_of(top).actions() if not entry.isSeparator()]


@pytest.mark.all
def test_menus_follow_each_change_of_the_language():
    """Titles, entries, and tooltips with the reason why a command can't run."""
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    english = ["New Design", "Check", "Solve", "Cuts", "Overlay", "Export Print Files", "Design", "Show",
               "Examples", "Help"]
    german = ["Neuer Entwurf", "Machbarkeit", "Lösen", "Schnitte", "Überlagerung",
              "Druckdateien exportieren", "Entwurf", "Zeigen", "Beispiele", "Hilfe"]
    solve = action("CurveUps_Solve")
    for language, texts, reason in (("German", german, "Es gibt keinen Entwurf"),
                                    ("English", english, "There is no design")) * 2:
        FreeCADGui.setLocale(language)
        until(lambda: menu_texts() == texts, 10, f"{texts} in place of {menu_texts()}")
        # FreeCAD translates the titles itself, with each change anew.
        assert [titles[-1] for titles, _ in menus()] == ["&CurveUps", "Design", "Show", "Examples", "Help"]
        for name, active in (("NewDesign", True), ("Solve", False)):  # FreeCAD asks after each event
            assert FreeCADGui.Command.get(f"CurveUps_{name}").isActive() == active
        assert reason in solve.toolTip(), solve.toolTip()


def test_errors_are_german(tmp_path, pictures):
    """Errors of the native module and of a reader, with their numbers and names."""
    FreeCADGui.setLocale("German")
    try:
        document, design = example("half-sphere", L=14)
        design.PMin, design.PMax = 2, 1
        document.recompute()
        assert "PMin (2 mm) is larger than PMax (1 mm)" in design.Reasons[0]  # for scripts
        design.ViewObject.doubleClicked()
        until(lambda: panel() is not None, 10, "the panel")
        verdict = panel().form.verdict.text()
        assert "PMin (2 mm) ist größer als PMax (1 mm)" in verdict, verdict
        click(panel().form.solve)
        until(lambda: panel().form.line.text(), 10, "the refusal")
        assert "verringern oder" in panel().form.line.text(), panel().form.line.text()
        picture("refused")
        panel().reject()
        (tmp_path / "cut.stl").write_text("solid cut\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n")
        FreeCADGui.Selection.clearSelection()
        in_dialog(lambda: press("CurveUps_NewDesign"), lambda: choose_file(str(tmp_path / "cut.stl")))
        until(lambda: len(designs.designs(document)) == 2, 10, "a design")
        press("CurveUps_Solve")
        until(lambda: not LIVE.busy and panel().form.line.text(), 30, "the refusal")
        assert "die Datei endet zu früh" in panel().form.line.text(), panel().form.line.text()
        assert not ENGLISH.search(panel().form.line.text().replace(str(tmp_path), ""))
        picture("broken")
    finally:
        FreeCADGui.setLocale("English")


def test_the_preference_page_keeps_what_panels_show(dome_document, pictures):
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    store = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/CurveUps")

    def change():
        dialog = QtGui.QApplication.activeModalWidget()
        view, place = next((view, place) for view in dialog.findChildren(QtGui.QAbstractItemView)
                           if view.isVisible() for place in view.model().match(
                               view.model().index(0, 0), QtCore.Qt.DisplayRole, "CurveUps", 1,
                               QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive))
        view.scrollTo(place)
        settle(200)
        click_at(view.viewport().mapToGlobal(view.visualRect(place).center()))
        box = widget("all_parameters")
        picture("preferences")
        click(box)
        fill(widget("export_mask"), "{name}_{body}")
        keys("Return")

    try:
        in_dialog(lambda: choose(lambda: menu_bar("Edit"), entry_of("Std_DlgPreferences")), change)
        document, design = opened(dome_document)
        form = show(SolvePanel, design).form
        assert form.all.isChecked() and form.findChild(QtGui.QWidget, "MaximumDeviation") is not None
        assert show(ExportPanel, design).form.names.text() == "{name}_{body}"
    finally:
        store.RemBool("AllParameters")
        store.RemString("ExportMask")
