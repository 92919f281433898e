# SPDX-License-Identifier: LGPL-2.1-or-later
"""Change Target: gives a design another surface or file."""

from __future__ import annotations

from typing import Any

from ...base.native import problem
from ...features.actions import transaction
from ..macro import call, named
from ..qt import QT_TRANSLATE_NOOP, translate
from .command import DesignCommand
from .new_design import ask_for_file, selected_surface


class Target(DesignCommand):
    """CurveUps_Target"""

    name = "CurveUps_Target"
    text = QT_TRANSLATE_NOOP("CurveUps_Target", "Change Target")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Target",
                                "Give the design another surface: the selected Part or Mesh object, or a "
                                "file")

    def reason(self) -> str:
        return super().reason() or str(problem() or "")

    def work(self, design: Any) -> None:
        source = selected_surface()
        text = named(source) if source is not None else ""
        if not text:
            path = ask_for_file(translate(self.name, "Surface of the design"))
            text = repr(path) if path else ""
        if text:
            with transaction(design.Document, translate(self.name, self.text)):
                call("document.set_source", named(design), text)
            design.Document.recompute()


COMMAND = Target()
