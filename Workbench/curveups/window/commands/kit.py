# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kit: writes all that is needed from the order of the print to the finished shell."""

from __future__ import annotations

from typing import Any

from ...features import actions
from ...kit.files import Order
from ..macro import call, named
from ..qt import QT_TRANSLATE_NOOP, QtCore, QtGui, translate
from ..run import LIVE, Task
from ..runs import reason
from ..selection import chosen_design
from .command import DesignCommand
from .report import folder_of


class Kit(DesignCommand):
    """CurveUps_Kit"""

    name = "CurveUps_Kit"
    text = QT_TRANSLATE_NOOP("CurveUps_Kit", "Fabrication Kit")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Kit",
                                "Write the order for the print shop, templates for the latex and the steps "
                                "of assembly, and open the steps")

    def reason(self) -> str:
        return super().reason() or reason("kit", chosen_design())

    def work(self, design: Any) -> None:
        folder = folder_of(design, "kit")

        def opened(design: Any, written: actions.WrittenKit) -> None:
            actions.hand_over("kit", design, written)
            call("actions.kit", named(design), repr(str(folder)), f"language={order.language!r}")
            QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(written.page))

        order = Order(language=translate("CurveUps_Sheets", "en"))
        work = actions.kit_work(design, str(folder), order)
        LIVE.start(design, Task(translate(self.name, self.text), work, opened))


COMMAND = Kit()
