# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's start needs of the window: everything else is imported when it is used first."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from ..features import proxy

# Types of files of FreeCAD's File > Export, with the modules that write them.
_EXPORTS = {"STL Mesh (*.stl *.ast)": ("Mesh",), "3D Manufacturing Format (*.3mf)": ("Mesh",),
            "STEP with colors (*.step *.stp)": ("Import", "ImportGui")}


def install() -> None:
    """Gives document objects their views, from the first one on, and FreeCAD's export of designs our
    writers."""
    proxy.attach_view, proxy.show_error = _attach, _show_error
    proxy.selection = FreeCADGui.Selection.getSelection
    for name, modules in _EXPORTS.items():
        for module in modules:
            FreeCAD.changeExportModule(name, module, "curveups.features.file_export")


def _attach(obj: Any) -> None:
    from .viewproviders.attaching import attach

    attach(obj)


def _show_error(error: Exception) -> None:
    from .notice import show_error

    show_error(error)
