# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Worst Contacts: contacts and tiles by the value of a field, the worst first."""

from __future__ import annotations

from typing import Any

import FreeCAD

from ...base.errors import tile_name
from ..overlay.fields import MEMBRANE, Field
from ..qt import QtWidgets, translate
from ..units import text_of
from .panel import Panel, fill_fields

_MOST = 300  # rows


class WorstContactsPanel(Panel):
    """A click on a row selects its tiles and turns the camera to them."""

    def __init__(self, design: Any):
        super().__init__(design, "worst_contacts",
                         translate("CurveUps_WorstContacts", "Worst of {name}", name=design.Label))
        form = self.form
        self._filling, self._shown = False, None  # type: bool, Any
        form.rows.setColumnCount(2)
        form.rows.setHorizontalHeaderLabels([translate("CurveUps_WorstContacts", "Tiles"),
                                             translate("CurveUps_WorstContacts", "Value")])
        form.rows.verticalHeader().setVisible(False)
        form.rows.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        self._follow()
        form.field.currentIndexChanged.connect(lambda *_: self._set_field())
        form.rows.itemSelectionChanged.connect(lambda: self._go())

    def show(self) -> None:
        """The field that the overlay shows."""
        form = self.form
        one = self._overlay.field()
        self._filling = True
        try:
            names = [name for name, field in self._fields().items() if field.on != MEMBRANE]
            fill_fields(form.field, names)
            if one is None or one.name not in names:
                form.field.setCurrentIndex(-1)
                form.rows.setRowCount(0)
                self._shown = None
                return
            form.field.setCurrentIndex(form.field.findData(one.name))
            form.note.setText(self._overlay.age(one))
            form.note.setVisible(bool(form.note.text()))
            schema = FreeCAD.Units.getSchema()
            if (one, schema) != self._shown:
                self._fill(one)
                self._shown = one, schema
        finally:
            self._filling = False

    def _fields(self) -> dict[str, Field]:
        return self._overlay.scene.fields if self._overlay.scene else {}

    def _fill(self, one: Field) -> None:
        rows, scene = self.form.rows, self._overlay.scene
        problems = set(map(int, one.problems))
        worst = [int(number) for number in one.order[:_MOST]]
        rows.setRowCount(len(worst))
        self._tiles = [scene.tiles_of(one, number) for number in worst]
        for row, number in enumerate(worst):
            value = text_of(one.worst[number], one.unit, one.size)
            texts = " – ".join(map(tile_name, self._tiles[row])), value + " ✗" * (number in problems)
            for column, text in enumerate(texts):
                rows.setItem(row, column, QtWidgets.QTableWidgetItem(text))
        left = len(one.order) - len(worst)
        self.form.count.setText(
            translate("CurveUps_WorstContacts", "with problems: {count}", count=len(problems))
            + (translate("CurveUps_WorstContacts", "; better ones that are not listed: {left}", left=left)
               if left else ""))

    def _set_field(self) -> None:
        name = self.form.field.currentData()
        if not self._filling and name:
            self._overlay.set_field(name)

    def _go(self) -> None:
        chosen = {index.row() for index in self.form.rows.selectedIndexes()}
        if self._filling or not chosen:
            return
        tiles = [tile for row in sorted(chosen) for tile in self._tiles[row]]
        self._overlay.select_tiles(tiles)
        self._overlay.look_at(tiles)
