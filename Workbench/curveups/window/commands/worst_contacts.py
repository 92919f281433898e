# SPDX-License-Identifier: LGPL-2.1-or-later
"""Worst Contacts: lists contacts and tiles, and leads to them."""

from __future__ import annotations

from ..panels.worst_contacts import WorstContactsPanel
from ..qt import QT_TRANSLATE_NOOP
from ..selection import chosen_design
from .command import PanelCommand
from .showing import missing


class WorstContacts(PanelCommand):
    """CurveUps_WorstContacts"""

    name = "CurveUps_WorstContacts"
    text = QT_TRANSLATE_NOOP("CurveUps_WorstContacts", "Worst Contacts")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_WorstContacts",
                                "List contacts and tiles, the worst first. Click one to go there")
    panel = WorstContactsPanel

    def reason(self) -> str:
        return super().reason() or missing(chosen_design(), layout=False)


COMMAND = WorstContacts()
