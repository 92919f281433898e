# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report: writes the report on a design as a page with pictures."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from ...features import actions
from ..qt import QT_TRANSLATE_NOOP, QtCore, QtGui, translate
from ..run import LIVE, Task
from ..runs import finish, reason
from ..selection import chosen_design
from .command import DesignCommand


class Report(DesignCommand):
    """CurveUps_Report"""

    name = "CurveUps_Report"
    text = QT_TRANSLATE_NOOP("CurveUps_Report", "Report")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Report",
                                "Write report.html, with verdict, pictures and figures, and open it")

    def reason(self) -> str:
        return super().reason() or reason("report", chosen_design())

    def work(self, design: Any) -> None:
        folder = _folder_of(design)

        def opened(design: Any, page: str) -> None:
            finish("report", design, page, repr(str(folder)))
            QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(page))

        work = actions.report_work(design, str(folder))
        LIVE.start(design, Task(translate(self.name, self.text), work, opened))


def _folder_of(design: Any) -> Path:
    """Beside the document; in a temporary folder where that was never saved."""
    saved = design.Document.FileName
    place = Path(saved).parent if saved else Path(tempfile.mkdtemp(prefix="curveups-"))
    return place / f"{actions.file_name(design)}-report"


COMMAND = Report()
