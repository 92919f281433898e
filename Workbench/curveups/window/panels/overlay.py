# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels of Overlay (field, range, colours, folding, values of the selected tiles) and of Worst Contacts
(contacts and tiles by the value of a field, the worst first)."""

from __future__ import annotations

from typing import Any

import FreeCAD

from ...base.errors import tile_name
from ..overlay import colours
from ..overlay.fields import MEMBRANE, Field
from ..overlay.overlay import AUTOMATIC
from ..overlay.scene import NO_FIELD
from ..qt import QT_TRANSLATE_NOOP, QtWidgets, translate
from ..units import text_of, user_unit
from .panel import Panel, enable, fill_fields

# Shown by names that stand elsewhere.
_MARKED = (QT_TRANSLATE_NOOP("CurveUps_ColourMaps", "Automatic"),
           QT_TRANSLATE_NOOP("CurveUps_ColourMaps", "Blue-Orange"),
           QT_TRANSLATE_NOOP("CurveUps_ColourMaps", "Grey"), QT_TRANSLATE_NOOP("CurveUps_Fields", "None"))
_STEPS = 200  # of the slider
_MOST_TILES = 50


class OverlayPanel(Panel):
    """What is chosen here is kept by the view provider at once, and followed where
    it is chosen elsewhere."""

    def __init__(self, design: Any):
        super().__init__(design, "overlay",
                         translate("CurveUps_Overlay", "Overlay of {name}", name=design.Label))
        form = self.form
        self._view = design.ViewObject
        self._filling = False
        for name in (AUTOMATIC, *colours.NAMES):
            form.map.addItem(translate("CurveUps_ColourMaps", name), name)
        form.morph.setRange(0, _STEPS)
        self._follow()
        form.field.currentIndexChanged.connect(lambda *_: self._set("Field", form.field.currentData()))
        form.map.currentIndexChanged.connect(lambda *_: self._set("ColourMap", form.map.currentData()))
        for box, name in ((form.pins, "Pins"), (form.membranes, "Membranes"), (form.both, "Both")):
            box.toggled.connect(lambda on, name=name: self._set(name, on))
        form.low.valueChanged.connect(lambda *_: self._set_range())
        form.high.valueChanged.connect(lambda *_: self._set_range())
        form.automatic.clicked.connect(lambda *_: self._overlay.set_range(None))
        form.morph.valueChanged.connect(lambda step: self._fold(step))

    def show(self) -> None:
        """The overlay as it is."""
        form, overlay, view = self.form, self._overlay, self._view
        self._filling = True
        try:
            fill_fields(form.field, [*overlay.fields(), NO_FIELD])
            one = overlay.field()
            form.field.setCurrentIndex(form.field.findData(one.name if one else NO_FIELD))
            form.map.setCurrentIndex(form.map.findData(view.ColourMap))
            for box, on in ((form.pins, view.Pins), (form.membranes, view.Membranes), (form.both, view.Both)):
                box.setChecked(on)
            flat = overlay.scene is not None and overlay.scene.flat is not None
            lacks = "" if flat else translate("CurveUps", "There is no layout yet: Solve makes it")
            enable(form.morph, lacks or (translate("CurveUps_Overlay", "Side by side shows both ends")
                                         if view.Both else ""))
            enable(form.both, lacks)
            enable(form.membranes, lacks)
            form.morph.setValue(round(_STEPS * overlay.morph()))
            self._show_range(one)
            form.note.setText(overlay.age(one) or overlay.note)
            form.note.setVisible(bool(form.note.text()))
            self._show_values()
        finally:
            self._filling = False

    def _show_range(self, one: Any) -> None:
        low, high = self._overlay.range()
        factor, unit = user_unit(one.unit if one else "", max(abs(low), abs(high)))
        self._factor = factor
        plain = "" if one is not None else translate("CurveUps_Overlay", "Choose a value to colour by first")
        for box, value in ((self.form.low, low), (self.form.high, high)):
            enable(box, plain)
            box.setSuffix(f" {unit}" if unit else "")
            box.setSingleStep(max(1e-4, 0.02 * (high - low) * factor))
            if not box.hasFocus():
                box.setValue(value * factor)
        enable(self.form.automatic, plain)

    def _show_values(self) -> None:
        tree = self.form.values
        tree.clear()
        for tile in self._overlay.selected[:_MOST_TILES]:
            top = QtWidgets.QTreeWidgetItem(tree, [tile_name(tile)])
            for name, values in self._overlay.values_of(tile):
                QtWidgets.QTreeWidgetItem(top, [f"{name}\n{values}"])
            top.setExpanded(True)
        self.form.hint.setVisible(not self._overlay.selected)

    def _set(self, name: str, value: Any) -> None:
        if not self._filling and value is not None:
            setattr(self._view, name, value)

    def _set_range(self) -> None:
        low, high = self.form.low.value() / self._factor, self.form.high.value() / self._factor
        if not self._filling and low < high:
            self._overlay.set_range((low, high))

    def _fold(self, step: int) -> None:
        if not self._filling:
            self._overlay.folding = None
            self._overlay.set_morph(step / _STEPS)


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
            fields = self._overlay.scene.fields if self._overlay.scene else {}
            names = [name for name, field in fields.items() if field.on != MEMBRANE]
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
