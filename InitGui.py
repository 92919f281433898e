# SPDX-License-Identifier: LGPL-2.1-or-later
"""Registers the workbench. Nothing heavy is imported before it is activated."""

import FreeCADGui


class CurveUpsWorkbench(FreeCADGui.Workbench):
    """Curvy shells that are printed flat and pulled into shape by pre-stretched membranes."""

    MenuText = "CurveUps"
    ToolTip = "Curvy shells that form from a flat print"

    def __init__(self):
        import os

        import curveups

        root = os.path.dirname(os.path.dirname(os.path.dirname(curveups.__file__)))
        self.__class__.Icon = os.path.join(root, "resources", "icons", "CurveUpsWorkbench.svg")

    def Initialize(self):
        """Called when the workbench is first activated."""

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(CurveUpsWorkbench())
