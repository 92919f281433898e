# SPDX-License-Identifier: LGPL-2.1-or-later
"""Overlay (field, range, colours, folding, values of the selected tiles) and Worst Contacts (contacts and
tiles by the value of a field, the worst first)."""

from __future__ import annotations

from functools import partial
from typing import Any, Optional

import FreeCAD

from ...base.errors import tile_name
from ..binding import Binding, silent
from ..panel import Panel, put
from ..qt import QT_TRANSLATE_NOOP, QtWidgets, translate
from ..units import text_of, user_unit
from . import colours
from .fields import MEMBRANE, Field
from .overlay import AUTOMATIC
from .scene import NO_FIELD

# Names that other modules have in English.
_TRANSLATED = (QT_TRANSLATE_NOOP("CurveUps_ColourMaps", "Automatic"),
               QT_TRANSLATE_NOOP("CurveUps_ColourMaps", "Blue-Orange"),
               QT_TRANSLATE_NOOP("CurveUps_ColourMaps", "Grey"), QT_TRANSLATE_NOOP("CurveUps_Fields", "None"))
_STEPS = 200  # of the slider
_MOST_TILES, _MOST_ROWS = 50, 300


class OverlayPanel(Panel):
    """Choices of how a design is drawn. The view provider keeps them at once, and the panel follows changes
    that are made elsewhere."""

    def __init__(self, design: Any):
        super().__init__(design, "overlay")
        form, view = self.form, design.ViewObject
        self._view, self._factor = view, 1.0
        for name in (AUTOMATIC, *colours.NAMES):
            form.map.addItem(translate("CurveUps_ColourMaps", name), name)
        form.morph.setRange(0, _STEPS)
        self._bindings = {name: Binding(widget, view, name, partial(self._set, name))
                          for widget, name in ((form.map, "ColourMap"), (form.pins, "Pins"),
                                               (form.membranes, "Membranes"), (form.both, "Both"))}
        self.reasons = {"morph": self._no_morph, "both": self._no_layout, "membranes": self._no_layout,
                        **dict.fromkeys(("low", "high", "automatic"), self._no_field)}
        self.follow()
        form.field.currentIndexChanged.connect(lambda *_: self._overlay.set_field(form.field.currentData()))
        form.low.valueChanged.connect(lambda *_: self._set_range())
        form.high.valueChanged.connect(lambda *_: self._set_range())
        self.on_clicks(automatic=lambda: self._overlay.set_range(None))
        form.morph.valueChanged.connect(lambda step: self._overlay.set_morph(step / _STEPS))

    def show(self) -> None:
        form, overlay = self.form, self._overlay
        field = overlay.field()
        with silent(form.field, form.low, form.high, form.morph):
            _list_fields(form.field, [*overlay.fields(), NO_FIELD], field.name if field else NO_FIELD)
            form.morph.setValue(round(_STEPS * overlay.morph()))
            self._show_range(field)
        for binding in self._bindings.values():
            binding.show()
        put(form.note, overlay.age(field) or overlay.note)
        self._show_values()

    def _show_range(self, field: Optional[Field]) -> None:
        low, high = self._overlay.range()
        self._factor, unit = user_unit(field.unit if field else "", max(abs(low), abs(high)))
        for box, value in ((self.form.low, low), (self.form.high, high)):
            box.setSuffix(f" {unit}" if unit else "")
            box.setSingleStep(max(1e-4, 0.02 * (high - low) * self._factor))
            if not box.hasFocus():
                box.setValue(value * self._factor)

    def _show_values(self) -> None:
        tree = self.form.values
        tree.clear()
        for tile in self._overlay.selected[:_MOST_TILES]:
            top = QtWidgets.QTreeWidgetItem(tree, [tile_name(tile)])
            for name, values in self._overlay.values_of(tile):
                QtWidgets.QTreeWidgetItem(top, [f"{name}\n{values}"])
            top.setExpanded(True)
        self.form.hint.setVisible(not self._overlay.selected)

    def _no_layout(self) -> str:
        scene = self._overlay.scene
        if scene is not None and scene.flat is not None:
            return ""
        return translate("CurveUps", "There is no layout yet: Solve makes it")

    def _no_morph(self) -> str:
        return self._no_layout() or (translate("CurveUps_Overlay", "Side by side shows both ends")
                                     if self._view.Both else "")

    def _no_field(self) -> str:
        if self._overlay.field() is not None:
            return ""
        return translate("CurveUps_Overlay", "Choose a value to colour by first")

    def _set(self, name: str) -> None:
        setattr(self._view, name, self._bindings[name].value)

    def _set_range(self) -> None:
        low, high = self.form.low.value() / self._factor, self.form.high.value() / self._factor
        if low < high:
            self._overlay.set_range((low, high))


class WorstContactsPanel(Panel):
    """Contacts or tiles, the worst first. A click on a row selects its tiles and turns the camera to them."""

    def __init__(self, design: Any):
        super().__init__(design, "worst_contacts")
        form = self.form
        self._shown: Any = None  # the field that is listed, and its schema of units
        self._tiles: list[list[int]] = []  # by row
        form.rows.verticalHeader().setVisible(False)
        form.rows.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        self.follow()
        form.field.currentIndexChanged.connect(lambda *_: self._overlay.set_field(form.field.currentData()))
        form.rows.itemSelectionChanged.connect(lambda: self._go())

    def show(self) -> None:
        form, scene, field = self.form, self._overlay.scene, self._overlay.field()
        names = [name for name, known in scene.fields.items() if known.on != MEMBRANE] if scene else []
        if field is not None and field.name not in names:
            field = None
        put(form.note, self._overlay.age(field) if field else "")
        with silent(form.field, form.rows):
            _list_fields(form.field, names, field.name if field else "")
            if (field, FreeCAD.Units.getSchema()) != self._shown:
                self._shown = field, FreeCAD.Units.getSchema()
                self._fill(field)

    def _fill(self, field: Optional[Field]) -> None:
        rows, scene = self.form.rows, self._overlay.scene
        if field is None:
            rows.setRowCount(0)
            return
        problems = set(map(int, field.problems))
        worst = [int(number) for number in field.order[:_MOST_ROWS]]
        rows.setRowCount(len(worst))
        self._tiles = [scene.tiles_of(field, number) for number in worst]
        for row, number in enumerate(worst):
            value = text_of(field.worst[number], field.unit, field.size)
            texts = " – ".join(map(tile_name, self._tiles[row])), value + " ✗" * (number in problems)
            for column, text in enumerate(texts):
                rows.setItem(row, column, QtWidgets.QTableWidgetItem(text))
        self.form.count.setText(
            translate("CurveUps_WorstContacts", "{shown} of {count} shown", shown=len(worst),
                      count=len(field.order))
            + (translate("CurveUps_WorstContacts", ", {count} with problems", count=len(problems))
               if problems else ""))

    def _go(self) -> None:
        rows = sorted({index.row() for index in self.form.rows.selectedIndexes()})
        self.go_to([tile for row in rows for tile in self._tiles[row]])


def _list_fields(box: Any, names: list[str], current: str) -> None:
    """List fields by name in a box, and show the current one."""
    if names != [box.itemData(k) for k in range(box.count())]:
        box.clear()
        for name in names:
            box.addItem(translate("CurveUps_Fields", name), name)
    box.setCurrentIndex(box.findData(current))
