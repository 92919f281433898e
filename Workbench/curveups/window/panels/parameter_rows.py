# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of a form for parameters of a design: one table's names, units, ranges and tooltips, FreeCAD's own
fields with expressions and the user's units. Edits reach the document when the user pauses."""

from __future__ import annotations

from types import MappingProxyType
from typing import Any, Callable, Mapping

import FreeCAD
import FreeCADGui

from ...features.actions import transaction
from ..notice import errors_shown
from ..overlay.watching import unit_observers
from ..qt import QtCore, QtWidgets, freecad_field, translate
from ..runs import assign
from ..units import show_number, whole
from .preferences import plain

PAUSE = 400  # ms without typing after which an edit counts

_NARROW = 80  # pixels of a field

Changed = Callable[[], object]


class ParameterRows:
    """Fields for some properties of one object, put into the layout `place`. changed: called after
    properties were set. beside: makes what stands beside the field of a property, by its name."""

    def __init__(self, place: Any, obj: Any, names: list[str], changed: Changed,
                 beside: Mapping[str, Callable[[], Any]] = MappingProxyType({})):
        self._object, self._changed = obj, changed
        self._page = QtWidgets.QWidget()
        form = QtWidgets.QFormLayout(self._page)
        form.setContentsMargins(0, 0, 0, 0)
        form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        self._pending: dict[str, Any] = {}
        self._fields: dict[str, Any] = {}
        self._labels: dict[str, Any] = {}
        self._bindings: list[Any] = []
        self._filling = False
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(lambda: self.flush())
        for name in names:
            field = self._make(name)
            field.setObjectName(name)
            # FreeCAD's fields ask for the width of their largest number, more than its dock has.
            field.setMinimumWidth(_NARROW)
            label = self._labels[name] = QtWidgets.QLabel(_spaced(name))
            form.addRow(label, _in_row(field, beside[name]()) if name in beside else field)
            self._fields[name] = field
        place.addWidget(self._page)
        self.refresh()
        unit_observers.append(self._show_units)

    def refresh(self) -> None:
        """Shows what the properties hold, but for edits that wait."""
        self._filling = True
        try:
            for name, field in self._fields.items():
                if name not in self._pending:
                    _show(field, getattr(self._object, name))
            self._show_tips()
        finally:
            self._filling = False

    def flush(self) -> None:
        """Sets the properties that were edited: all at once, as one step of undo. No transaction is left
        open in between, since solids wait for its end."""
        self._timer.stop()
        pending, self._pending = self._pending, {}
        # A field that follows an expression or a script says what the property has already.
        pending = {name: value for name, value in pending.items()
                   if value != plain(getattr(self._object, name))}
        if not pending:
            return
        document = self._object.Document
        with errors_shown(""):
            with transaction(document, translate("CurveUpsSolve", "Edit the design")):
                for name, value in pending.items():
                    assign(self._object, name, value)
                document.recompute()
            self._changed()
        self.refresh()

    def close(self) -> None:
        """No edit comes any more, and the fields are gone. They are deleted together with what
        PySide knows of them: it would take a later field at the address of one for the deleted one."""
        self.stop()
        self._bindings.clear()
        self._fields.clear()
        self._labels.clear()
        self._page.hide()  # or Qt still shows it, as a window, where it was never seen in the panel
        self._page.setParent(None)
        self._page.deleteLater()

    def stop(self) -> None:
        """No edit comes any more; the fields may be gone."""
        self._timer.stop()
        if self._show_units in unit_observers:
            unit_observers.remove(self._show_units)
        self._pending = {}

    def _show_units(self) -> None:
        """The user's unit schema is another: fields write their numbers anew."""
        self._filling = True
        try:
            for name, field in self._fields.items():
                value = getattr(self._object, name)
                if hasattr(value, "Unit"):
                    field.setProperty("unit", value.getUserPreferred()[2])
                    # Not the field's own number, which is read from the digits of its text.
                    number = self._pending.get(name, value.Value)
                    show_number(field, FreeCAD.Units.Quantity(number, value.Unit))
            self._show_tips()
        except (RuntimeError, ReferenceError):  # the panel or the design went without a word
            unit_observers.remove(self._show_units)
        finally:
            self._filling = False

    def _show_tips(self) -> None:
        """What parameters mean, and their values, of which fields show three digits."""
        for name, field in self._fields.items():
            about = translate("App::Property", self._object.getDocumentationOfProperty(name))
            value = getattr(self._object, name)
            for part in (field, self._labels[name]):
                part.setToolTip(f"{about}\n= {whole(value)}" if hasattr(value, "Unit") else about)

    def _edit(self, name: str, value: Any) -> None:
        if self._filling:
            return
        self._pending[name] = value
        self._timer.start(PAUSE)

    def _make(self, name: str) -> Any:
        kind = self._object.getTypeIdOfProperty(name)
        if kind == "App::PropertyBool":
            field = QtWidgets.QCheckBox()
            field.toggled.connect(lambda value: self._edit(name, bool(value)))
        elif kind == "App::PropertyEnumeration":
            field = QtWidgets.QComboBox()
            field.addItems(self._object.getEnumerationsOfProperty(name))
            field.currentTextChanged.connect(lambda value: self._edit(name, str(value)))
        elif kind == "App::PropertyString":
            field = QtWidgets.QLineEdit()
            field.textEdited.connect(lambda value: self._edit(name, str(value)))
        else:
            field = self._number(name)
        return field

    def _number(self, name: str) -> Any:
        field = freecad_field("Gui::QuantitySpinBox")
        field.valueChanged.connect(lambda *_: self._edit_number(name))
        value = getattr(self._object, name)
        if hasattr(value, "Unit"):
            field.setProperty("unit", value.getUserPreferred()[2])
        binding = FreeCADGui.ExpressionBinding(field)
        binding.bind(self._object, name)
        self._bindings.append(binding)  # lives as long as the field
        return field

    def _edit_number(self, name: str) -> None:
        field = self._fields.get(name)
        if field is not None:
            self._edit(name, field.property("rawValue"))  # in FreeCAD's own units


def _in_row(field: Any, other: Any) -> Any:
    row = QtWidgets.QHBoxLayout()
    row.addWidget(field, 1)
    row.addWidget(other)
    return row


def _show(field: Any, value: Any) -> None:
    if isinstance(field, QtWidgets.QCheckBox):
        field.setChecked(value)
    elif isinstance(field, QtWidgets.QComboBox):
        field.setCurrentText(value)
    elif isinstance(field, QtWidgets.QLineEdit):
        field.setText(value)
    elif not field.hasFocus() or field.property("rawValue") != plain(value):  # or while it is typed
        show_number(field, value)


def _spaced(name: str) -> str:
    """DGapMin as D Gap Min, as the property editor writes it."""
    return "".join(f" {letter}" if letter.isupper() and number and not name[number - 1].isupper() else letter
                   for number, letter in enumerate(name))
