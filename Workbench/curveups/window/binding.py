# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets bound to properties of a document object, and a form of them for parameters."""

from __future__ import annotations

from contextlib import contextmanager, suppress
from functools import partial
from types import MappingProxyType
from typing import Any, Callable, Iterator, Mapping

import FreeCAD
import FreeCADGui

from ..features import properties
from ..features.actions import transaction
from .notice import errors_shown
from .preferences import plain
from .qt import QT_TRANSLATE_NOOP, QtCore, QtWidgets, freecad_field, scroll_past, translate
from .run import assign
from .units import show_number, whole

PAUSE = 400  # ms without typing, after which an edit is written
_NARROW = 105  # px, width of a field
# Signal of an edit, value, and how another is shown, by kind of widget; others are FreeCAD's quantity fields.
_KINDS: dict[type, tuple[str, Callable[[Any], Any], Callable[[Any, Any], object]]] = {
    QtWidgets.QCheckBox: ("toggled", lambda box: box.isChecked(), lambda box, on: box.setChecked(on)),
    QtWidgets.QComboBox: ("currentIndexChanged", lambda box: box.currentData(),
                          lambda box, value: box.setCurrentIndex(box.findData(value))),
    QtWidgets.QLineEdit: ("textEdited", lambda line: line.text(), lambda line, text: line.setText(text))}


class Binding:
    """A widget that shows a property; `edited` is called without arguments after the user has changed it.

    Numbers are FreeCAD's quantity fields: they show the property's unit and take expressions."""

    def __init__(self, widget: Any, obj: Any, name: str, edited: Callable[[], object]):
        self.widget, self._object, self._name = widget, obj, name
        self._kind = next((_KINDS[kind] for kind in _KINDS if isinstance(widget, kind)), None)
        if self._kind is None:
            self._expression = FreeCADGui.ExpressionBinding(widget)
            self._expression.bind(obj, name)
        self.show(True)
        # `edited` must not refer to the widget: PySide would know it longer than Qt has it.
        signal = "valueChanged" if self._kind is None else self._kind[0]
        getattr(widget, signal).connect(lambda *_: edited())

    @property
    def value(self) -> Any:
        """Value that the widget shows, in FreeCAD's own units."""
        return self.widget.property("rawValue") if self._kind is None else self._kind[1](self.widget)

    def show(self, other_units: bool = False) -> None:
        """Show the property as it is. other_units: the user's unit schema has changed."""
        widget, value = self.widget, getattr(self._object, self._name)
        with silent(widget):
            if self._kind is not None:
                if self.value != value:
                    self._kind[2](widget, value)
                return
            if other_units and hasattr(value, "Unit"):
                widget.setProperty("unit", value.getUserPreferred()[2])
            # The text stays as it is typed while it says the same.
            if other_units or not widget.hasFocus() or self.value != plain(value):
                show_number(widget, value)


@contextmanager
def silent(*widgets: Any) -> Iterator[None]:
    """Keep widgets from sending signals while they are filled."""
    for widget in widgets:
        widget.blockSignals(True)
    try:
        yield
    finally:
        for widget in widgets:
            widget.blockSignals(False)


class ParameterRows:
    """A form with a field for each of some properties of `obj`, added to the layout `place`.

    Edits wait until the user pauses; one transaction then writes them all, recorded for macros.
    beside: makes the widget beside the field of a property, by its name."""

    def __init__(self, place: Any, obj: Any, names: list[str],
                 beside: Mapping[str, Callable[[], Any]] = MappingProxyType({})):
        self._object = obj
        self._page = QtWidgets.QWidget()
        form = QtWidgets.QFormLayout(self._page)
        form.setContentsMargins(0, 0, 0, 0)
        form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        self._edited: set[str] = set()
        self._schema = FreeCAD.Units.getSchema()
        self._bindings: dict[str, Binding] = {}
        self._labels: dict[str, Any] = {}
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(lambda: self.flush())
        for name in names:
            field = scroll_past(_field(obj, name))
            field.setObjectName(name)
            # FreeCAD's fields ask for the width of their largest number, more than its dock has.
            field.setMinimumWidth(_NARROW)
            label = self._labels[name] = QtWidgets.QLabel(_titled(name))
            form.addRow(label, _in_row(field, beside[name]()) if name in beside else field)
            self._bindings[name] = Binding(field, obj, name, partial(self._edit, name))
        place.addWidget(self._page)
        self.show()

    def show(self) -> None:
        """Show the properties, apart from those with an edit that waits."""
        schema = FreeCAD.Units.getSchema()
        other_units, self._schema = schema != self._schema, schema
        if other_units:
            self.flush()
        for name, binding in self._bindings.items():
            if name not in self._edited:
                binding.show(other_units)
            about = translate("App::Property", self._object.getDocumentationOfProperty(name))
            value = getattr(self._object, name)
            for part in (binding.widget, self._labels[name]):  # fields show three digits
                part.setToolTip(f"{about}\n= {whole(value)}" if hasattr(value, "Unit") else about)

    def flush(self) -> None:
        """Write all edits, as one step of undo."""
        self._timer.stop()
        values = {name: self._bindings[name].value for name in self._edited}
        self._edited.clear()
        # A field that follows an expression or a script shows what the property has already.
        values = {name: value for name, value in values.items()
                  if value != plain(getattr(self._object, name))}
        if not values:
            return
        with errors_shown(""), transaction(self._object.Document,
                                           translate("CurveUpsSolve", "Edit the design")):
            for name, value in values.items():
                assign(self._object, name, value)
            self._object.Document.recompute()

    def close(self) -> None:
        """Drop edits that wait, and delete the fields together with what PySide knows of them: it would take
        a later field at the address of one for the deleted one."""
        self._timer.stop()
        self._edited.clear()
        self._bindings.clear()
        self._labels.clear()
        with suppress(RuntimeError):  # the page went with the panel
            self._page.hide()  # Qt may show a page that was never seen as a window
            self._page.setParent(None)
            self._page.deleteLater()

    def _edit(self, name: str) -> None:
        self._edited.add(name)
        self._timer.start(PAUSE)


def _field(obj: Any, name: str) -> Any:
    """A widget for a property, by its type."""
    kind = obj.getTypeIdOfProperty(name)
    if kind == "App::PropertyBool":
        return QtWidgets.QCheckBox()
    if kind == "App::PropertyString":
        return QtWidgets.QLineEdit()
    if kind == "App::PropertyEnumeration":
        box = QtWidgets.QComboBox()
        for choice in obj.getEnumerationsOfProperty(name):
            box.addItem(choice, choice)
        return box
    field, row = freecad_field("Gui::QuantitySpinBox"), properties.parameter_of(name)
    if row is not None:
        limit(field, row, hasattr(getattr(obj, name), "Unit"))
    return field


def limit(field: Any, row: properties.Parameter, has_unit: bool = True) -> None:
    """Give FreeCAD's field of a number the range of its parameter. has_unit: of the property."""
    for end, value in (("minimum", row.minimum), ("maximum", row.maximum)):
        field.setProperty(end, properties.quantity(row, value).Value if has_unit else value)


def _in_row(field: Any, other: Any) -> Any:
    row = QtWidgets.QHBoxLayout()
    row.addWidget(field, 1)
    row.addWidget(other)
    return row


# Words for names that are symbols of the method.
_WORDS = {
    "L": QT_TRANSLATE_NOOP("CurveUpsSolve", "Edge length"),
    "HBody": QT_TRANSLATE_NOOP("CurveUpsSolve", "Thickness"),
    "HPin": QT_TRANSLATE_NOOP("CurveUpsSolve", "Pin height"),
    "DGapMin": QT_TRANSLATE_NOOP("CurveUpsSolve", "Least gap"),
    "PMin": QT_TRANSLATE_NOOP("CurveUpsSolve", "Pin inset"),
    "PFloor": QT_TRANSLATE_NOOP("CurveUpsSolve", "Least pin inset"),
    "PMax": QT_TRANSLATE_NOOP("CurveUpsSolve", "Largest pin inset"),
    "APinMin": QT_TRANSLATE_NOOP("CurveUpsSolve", "Pin area"),
    "APinFloor": QT_TRANSLATE_NOOP("CurveUpsSolve", "Least pin area"),
    "Tau": QT_TRANSLATE_NOOP("CurveUpsSolve", "Stretch"),
    "FMinRatio": QT_TRANSLATE_NOOP("CurveUpsSolve", "Least force ratio")}


def _titled(name: str) -> str:
    """Title of a property's field: in words, or as the property editor writes the name (Crease Angle)."""
    if name in _WORDS:
        return f"{translate('CurveUpsSolve', _WORDS[name])} ({name})"
    return "".join(f" {letter}" if letter.isupper() and number and not name[number - 1].isupper() else letter
                   for number, letter in enumerate(name))
