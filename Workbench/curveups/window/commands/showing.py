# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of the commands that choose what the view shows."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from ...features.document import has_layout
from ...features.status import has_tiles
from ..macro import named
from ..overlays import overlay_of
from ..qt import translate
from ..selection import chosen_design
from .command import DesignCommand


class ShowCommand(DesignCommand):
    """Calls a function of overlay/showing.py, recorded for macros in a window. It changes nothing but
    views, which undo leaves alone."""

    function = ""
    needs_layout = False  # or, without, tiles

    def reason(self) -> str:
        found = super().reason()
        return found or missing(chosen_design(), self.needs_layout)

    def work(self, design: Any) -> None:
        FreeCADGui.doCommandGui("from curveups.window.overlay import showing")
        FreeCADGui.doCommandGui(f"showing.{self.function}({named(design)})")


def missing(design: Any, layout: bool) -> str:
    """What a design lacks to be drawn, as a reason why a command can't run."""
    try:
        scene = overlay_of(design).scene
    except KeyError:
        scene = None
    if scene is None:  # a hidden design may have none yet
        there = has_layout(design) or not layout and has_tiles(design)
    else:
        there = not layout or scene.flat is not None
    if there:
        return ""
    if layout:
        return translate("CurveUps", "There is no layout yet: run Solve")
    return translate("CurveUps", "There are no tiles yet: run Solve")
