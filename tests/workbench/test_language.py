# SPDX-License-Identifier: LGPL-2.1-or-later
"""In a FreeCAD that speaks German menus, tooltips and panels do so too."""

import shutil

import pytest
from window import run_in_window

pytestmark = pytest.mark.skipif(not shutil.which("xvfb-run"), reason="there is no xvfb-run")

GERMAN = """
def work():
    FreeCADGui.setLocale('German')
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    settle(500)
    action = FreeCADGui.Command.get('CurveUps_Solve').getAction()[0]
    assert action.text() == 'Lösen', action.text()
    assert 'Kacheln' in action.toolTip(), action.toolTip()
    action = FreeCADGui.Command.get('CurveUps_NewDesign').getAction()[0]
    assert action.text() == 'Neuer Entwurf', action.text()
    from curveups.features.document import new_design
    from curveups.panels.solve import open_panel
    form = open_panel(new_design(FreeCAD.newDocument(), 'disc')).form
    assert form.stop.text() == 'Anhalten' and form.solve.text() == 'Lösen', form.stop.text()
    assert form.stages.headerItem().text(0) == 'Schritt', form.stages.headerItem().text(0)
    from curveups.commands.command import no_design
    FreeCAD.closeDocument(FreeCAD.ActiveDocument.Name)
    assert no_design().startswith('Es gibt keinen Entwurf'), no_design()
"""


def test_german(homes, tmp_path):
    out = run_in_window(GERMAN, homes[True], tmp_path)
    assert "Traceback" not in out, out
