# SPDX-License-Identifier: LGPL-2.1-or-later
"""In a FreeCAD that speaks German menus, tooltips and panels do so too."""

import FreeCAD
import FreeCADGui
import pytest
from curveups.features import document as designs
from curveups.features.document import new_design
from curveups.window.commands.command import no_design
from curveups.window.overlays import overlay_of
from curveups.window.panels.panel import show
from curveups.window.panels.solve import SolvePanel
from robot import QtCore, QtGui, settle

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
