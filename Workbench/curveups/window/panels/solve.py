# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a design: its parameters, and its runs as they go. It opens by a double click and by the
commands that run something; a run goes on when it is closed."""

from __future__ import annotations

import time
from functools import partial
from html import escape
from typing import Any, Callable

import FreeCAD

from ...base import profiles
from ...base.errors import CurveUpsError
from ...base.findings import first_of_each_kind
from ...features import properties
from ...features.live import stored, warnings_of
from ...features.status import CURRENT, INVALID, OUT_OF_DATE
from ...project.project import HOLDS
from ...project.size_choice import AUTOMATIC
from ...project.worker import Status
from ...stages import label_of
from ...stages.settle import Range
from .. import runs
from ..notice import errors_shown, shown
from ..qt import QT_TRANSLATE_NOOP, QtCore, QtWidgets, translate
from ..run import LIVE
from ..runs import call, named
from ..units import short
from . import preferences
from .check import choose_sizes
from .panel import Panel, enable, fit_columns
from .parameter_rows import ParameterRows

# What properties and the parameter table say in English; the panel translates it.
_MARKED = (
    QT_TRANSLATE_NOOP("CurveUpsSolve", "Target"), QT_TRANSLATE_NOOP("CurveUpsSolve", "Tiles"),
    QT_TRANSLATE_NOOP("CurveUpsSolve", "Layout"), QT_TRANSLATE_NOOP("CurveUpsSolve", "Physics"),
    QT_TRANSLATE_NOOP("CurveUpsSolve", "Repair"), QT_TRANSLATE_NOOP("CurveUpsSolve", "Bumps"),
    QT_TRANSLATE_NOOP("CurveUpsSolve", "Support"), QT_TRANSLATE_NOOP("CurveUpsSolve", "Anchors"),
    QT_TRANSLATE_NOOP("CurveUpsSolve", "Files"), QT_TRANSLATE_NOOP("CurveUpsSolve", "valid"),
    QT_TRANSLATE_NOOP("CurveUpsSolve", "not valid"), QT_TRANSLATE_NOOP("CurveUpsSolve", "not judged"),
    QT_TRANSLATE_NOOP("CurveUpsSolve", "holds"), QT_TRANSLATE_NOOP("CurveUpsSolve", "does not hold"),
    QT_TRANSLATE_NOOP("CurveUpsSolve", "not settled"), QT_TRANSLATE_NOOP("CurveUpsSolve", "out of date"),
    QT_TRANSLATE_NOOP("CurveUpsSolve", "empty"), QT_TRANSLATE_NOOP("CurveUpsSolve", "invalid"),
    QT_TRANSLATE_NOOP("CurveUpsSolve", "running"))
_MATERIALS = {
    "material_membrane": QT_TRANSLATE_NOOP("CurveUpsSolve", "Membrane"),
    "material_glue": QT_TRANSLATE_NOOP("CurveUpsSolve", "Glue"),
    "material_tile": QT_TRANSLATE_NOOP("CurveUpsSolve", "Material of tiles"),
}
# Of the process window: what may be off.
_RANGES = {
    "front_over_back": QT_TRANSLATE_NOOP("CurveUpsSolve", "Front over back"),
    "friction_coefficient": QT_TRANSLATE_NOOP("CurveUpsSolve", "Friction"),
}
DONE, RUNNING, WAITING = "✓", "▶", "·"


class SolvePanel(Panel):
    """Each pause in editing parameters ends a step of undo."""

    def __init__(self, design: Any):
        super().__init__(design, "solve", f"CurveUps: {design.Label}")
        self._ranges: Any = None  # that are shown, and in which schema of units
        self._began: dict[str, float] = {}
        self._prepare_buttons()
        self._prepare_parameters()
        self._follow()

    def close(self) -> None:
        """Ends edits. A run goes on."""
        if self.form is None:
            self._rows.stop()
        else:
            if not self._overlay.closed:
                self._rows.flush()
            self._rows.close()
        super().close()

    def run(self, which: str) -> None:
        """Starts a run: "solve", "verify", "repair", "build_solids"."""
        self._rows.flush()
        self._say("")
        self.form.stages.clear()
        self._began = {}
        with errors_shown(which):
            runs.start(which, self.design)

    def _prepare_buttons(self) -> None:
        form = self.form
        for which in ("solve", "verify", "repair"):
            getattr(form, which).clicked.connect(lambda *_, which=which: self.run(which))
        form.live.setChecked(preferences.draws_live())
        form.live.toggled.connect(lambda value: preferences.set_draws_live(bool(value)))
        fit_columns(form.stages)
        form.stages.setFixedHeight(8 * form.stages.fontMetrics().height())
        fit_columns(form.window)
        form.window.itemClicked.connect(self._select_failing)

    def _prepare_parameters(self) -> None:
        form = self.form
        self._groups: dict[str, list[str]] = {}
        known = set(self.design.PropertiesList)
        for row in properties.rows():
            name = properties.property_name(row.name)
            if name in known:
                self._groups.setdefault(row.group, []).append(name)
        for group in filter(self._groups.get, properties.GROUPS):
            form.group.addItem(translate("CurveUpsSolve", group), group)
        form.group.currentIndexChanged.connect(lambda *_: self._show_group())
        form.all.setChecked(preferences.group().GetBool("AllParameters", False))
        form.all.toggled.connect(lambda value: self._show_all(bool(value)))
        names = [name for group in self._groups.values() for name in group]
        form.remember.clicked.connect(lambda: preferences.remember(self.design, names))
        self._prepare_profiles()
        self._prepare_materials()
        self._rows = self._make_rows()

    def _prepare_profiles(self) -> None:
        menu = _menu(self.form.profile)
        for name in ("", *profiles.profile_names()):
            action = menu.addAction(name.upper() or translate("CurveUpsSolve", "Standard"))
            action.setToolTip(profiles.about(profiles.profile_path(name)) if name else translate(
                "CurveUpsSolve", "Set the defaults of all parameters that a profile sets"))
            action.triggered.connect(partial(self._apply, "actions.apply_profile", (name,)))

    def _prepare_materials(self) -> None:
        menu = _menu(self.form.materials)
        for kind, title in _MATERIALS.items():
            menu.addSection(translate("CurveUpsSolve", title))
            for name in profiles.material_names(kind):
                action = menu.addAction(name)
                action.setCheckable(True)
                action.setToolTip(profiles.about(profiles.material_path(name)))
                action.triggered.connect(partial(self._apply, "actions.apply_material", (kind, name)))
        menu.aboutToShow.connect(lambda: self._mark_materials(menu))

    def _mark_materials(self, menu: Any) -> None:
        values = properties.values_of(self.design)
        for action in menu.actions():
            if action.isCheckable():
                own = profiles.parameters(profiles.material_path(action.text()))
                action.setChecked(all(properties.same(values[name], value) for name, value in own.items()))

    def _apply(self, function: str, names: tuple[str, ...], *_: Any) -> None:
        """*_: what a click hands over."""
        self._rows.flush()
        with errors_shown(translate("CurveUpsSolve", "Parameters")):
            call(function, named(self.design), *map(repr, names))
            self.design.Document.recompute()
        self._rows.refresh()
        self.show()

    def _automatic(self, name: str) -> Any:
        """The button beside a size that looks for the largest of which a design is valid."""
        button = QtWidgets.QToolButton()
        button.setObjectName(f"auto_{name}")
        button.setText(translate("CurveUpsSolve", "Auto"))
        button.setToolTip(translate("CurveUpsSolve", "Solve with a few values, the largest first, until a "
                                                     "design is valid. A length also keeps the tiles within "
                                                     "MaximumDeviation of the surface"))
        button.clicked.connect(lambda *_: self._choose(name))
        return button

    def _choose(self, name: str) -> None:
        self._rows.flush()
        self._say("")
        choose_sizes(self.design, (name,))

    def turn_to(self, name: str) -> None:
        """Turns to a group of parameters; one that there is not is no harm."""
        number = self.form.group.findData(name)
        if number >= 0:
            self.form.group.setCurrentIndex(number)

    def _show_group(self) -> None:
        self._rows.flush()
        self._rows.close()
        self._rows = self._make_rows()

    def _make_rows(self) -> ParameterRows:
        names = self._groups.get(self.form.group.currentData(), [])
        basic = [name for name in names if (row := properties.parameter_of(name)) and row.basic]
        self.form.all.setVisible(0 < len(basic) < len(names))
        if basic and not self.form.all.isChecked():
            names = basic
        beside: dict[str, Callable[[], Any]] = {
            properties.property_name(name): partial(self._automatic, name) for name in AUTOMATIC}
        return ParameterRows(self.form.rows, self.design, names, self.show, beside)

    def _show_all(self, value: bool) -> None:
        preferences.group().SetBool("AllParameters", value)
        self._show_group()

    def show(self) -> None:
        """The verdict: it changes when solids follow, by undo, and by scripts."""
        state = self.design.Status
        head = ", ".join(translate("CurveUpsSolve", word) for word in (
            self.design.Verdict if state == "current" else state, self.design.Holds))
        found = self.design.Proxy.state(self.design)
        lines = [shown(reason) for reason in found.reasons[:6]]
        if found.state in (CURRENT, INVALID) and found.parts["Layout"][0] == CURRENT:
            lines += self._warnings()
        if getattr(self.design, "Kit", "").startswith(OUT_OF_DATE):
            lines.append(translate("CurveUpsSolve", "The fabrication kit is out of date"))
        self.form.verdict.setText(f"<b>{escape(self.design.Label)}: {escape(head)}</b>"
                                  + "".join(f"<br>{line}" for line in lines))
        self._show_window()

    def _warnings(self) -> list[str]:
        """The first of each kind."""
        try:
            warnings = first_of_each_kind(warnings_of(self.design))
        except CurveUpsError:  # of damaged results, which Status names
            return []
        lines = []
        for found, others in warnings[:6]:
            line = translate("CurveUpsSolve", "Warning: {what}").format(what=shown(found))
            more = translate("CurveUpsSolve", " (and {count} more of this kind)").format(count=others)
            lines.append(line + more * bool(others))
        return lines

    def _show_window(self) -> None:
        """The process window of the design as it is, where its run looked for one: only a design that holds
        has one."""
        tree, found = self.form.window, stored(self.design).latest("settle")
        ranges = found.window if found and self.design.Holds == HOLDS[True] else ()
        shown_now = ranges, FreeCAD.Units.getSchema()
        if shown_now == self._ranges:
            return
        self._ranges = shown_now
        tree.clear()
        for one in ranges:
            name = translate("CurveUpsSolve", _RANGES.get(one.parameter, one.parameter))
            item = QtWidgets.QTreeWidgetItem([name])
            item.setToolTip(0, name)
            for column, (mark, end, searched, failure) in enumerate(
                    zip("≤≥", one.ends, one.searched, one.failures), 1):
                item.setText(column, f"{mark} {_value(one, searched)}" if end is None else _value(one, end))
                item.setTextAlignment(column, QtCore.Qt.AlignRight)
                if failure:
                    item.setToolTip(column, shown(failure, False))
                    item.setData(column, QtCore.Qt.UserRole, list(failure.tiles))
            tree.addTopLevelItem(item)
        tree.setVisible(bool(ranges))
        tree.setFixedHeight(tree.header().sizeHint().height() + len(ranges) * tree.sizeHintForRow(0) + 4)

    def _select_failing(self, item: Any, column: int) -> None:
        """What fails first beyond the end that was clicked."""
        tiles = item.data(column, QtCore.Qt.UserRole)
        if tiles:
            self._overlay.select_tiles(tiles)
            self._overlay.look_at(tiles)

    def _show_running(self, running: bool) -> None:
        form = self.form
        for which in ("solve", "verify", "repair"):
            enable(getattr(form, which), runs.reason(which, self.design))
        enable(form.parameters, LIVE.obstacle() if running else "")

    def _show_run(self, status: Status, goes_on: bool) -> None:
        if goes_on and not LIVE.runs_on(self.design):
            return
        self._show_stage(status, goes_on)
        self._show_running(goes_on)
        if not goes_on and self.design.Document.Name in FreeCAD.listDocuments():
            self._rows.refresh()
            self.show()

    def _show_stage(self, status: Status, goes_on: bool) -> None:
        """A line for each stage that has begun."""
        tree, now = self.form.stages, time.perf_counter()
        count = tree.topLevelItemCount()
        last = tree.topLevelItem(count - 1) if count else None
        stage = status.stage
        if last is not None and last.text(0).startswith(RUNNING) and (
                not goes_on or last.data(0, QtCore.Qt.UserRole) != stage):
            _mark(last, DONE, last.text(0)[2:])
            last.setText(1, f"{now - self._began[last.data(0, QtCore.Qt.UserRole)]:.1f} s")
        if not goes_on or not stage:
            return
        if stage not in self._began:
            self._began[stage] = now
            last = QtWidgets.QTreeWidgetItem()
            _mark(last, RUNNING, translate("CurveUpsSolve", label_of(stage)))
            last.setData(0, QtCore.Qt.UserRole, stage)
            last.setTextAlignment(1, QtCore.Qt.AlignRight)
            tree.addTopLevelItem(last)
            tree.scrollToItem(last)
        if last is not None and last.data(0, QtCore.Qt.UserRole) == stage:
            last.setText(1, f"{now - self._began[stage]:.0f} s")


def _value(one: Range, value: float) -> str:
    """Of a process window, with its unit."""
    return f"{short(value)} {one.unit}".rstrip()


def _mark(item: Any, mark: str, stage: str) -> None:
    """The line of a stage, which may be wider than the dock."""
    item.setText(0, f"{mark} {stage}")
    item.setToolTip(0, item.text(0))


def _menu(button: Any) -> Any:
    menu = QtWidgets.QMenu(button)
    menu.setToolTipsVisible(True)
    button.setMenu(menu)
    return menu
