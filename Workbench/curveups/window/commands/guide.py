# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user guide."""

from __future__ import annotations

from ..guide import show_guide
from ..qt import QT_TRANSLATE_NOOP
from .command import Command


class Guide(Command):
    """CurveUps_Guide"""

    name = "CurveUps_Guide"
    text = QT_TRANSLATE_NOOP("CurveUps_Guide", "Guide")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Guide",
                                "From a surface to print files; F1 opens it at the command under the mouse "
                                "or at the panel that is open")

    def run(self) -> None:
        show_guide()


COMMAND = Guide()
