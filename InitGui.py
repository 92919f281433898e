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
        from curveups.features import proxy

        def attach(obj):
            """Give a document object its view; everything of the window is imported with the first one."""
            from curveups.window.viewproviders import attach

            attach(obj)

        proxy.attach_view = attach
        resources = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(curveups.__file__))),
                                 "resources")
        self.__class__.Icon = os.path.join(resources, "icons", "CurveUpsWorkbench.svg")
        FreeCADGui.addIconPath(os.path.join(resources, "icons"))
        FreeCADGui.addLanguagePath(os.path.join(resources, "translations"))
        FreeCADGui.updateLocale()

    def Initialize(self):
        """Called when the workbench is first activated."""
        from curveups.window import commands
        from curveups.window.qt import RESOURCES

        commands.register()
        self.appendToolbar("CurveUps", commands.steps())
        for titles, names in commands.menus():
            self.appendMenu(titles, names)
        FreeCADGui.addPreferencePage(str(RESOURCES / "ui" / "preferences.ui"), "CurveUps")

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(CurveUpsWorkbench())
