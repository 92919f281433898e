# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Overlay: field, range, colours, folding, and the values of the tiles that are selected."""

from __future__ import annotations

from typing import Any

from ...base.errors import tile_name
from ..overlay import colours
from ..overlay.overlay import AUTOMATIC
from ..overlay.scene import NO_FIELD
from ..qt import QT_TRANSLATE_NOOP, QtWidgets, translate
from ..units import user_unit
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
