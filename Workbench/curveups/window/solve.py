# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a design: its parameters, and its runs as they go. A double click opens it, and so do commands
that start a run. A run goes on when the panel closes."""

from __future__ import annotations

import time
from functools import partial
from html import escape
from pathlib import Path
from typing import Any, Callable

import FreeCAD

from ..base import profiles
from ..base.findings import first_of_each_kind
from ..features import properties
from ..features.actions import transaction
from ..features.design import stored, warnings_of
from ..features.status import CURRENT, EMPTY, INVALID, OUT_OF_DATE, RUNNING, status_of
from ..project.project import HOLDS
from ..project.size_choice import AUTOMATIC
from ..project.worker import Status
from ..stages import label_of
from ..stages.settle import Range
from . import preferences, run
from .binding import ParameterRows
from .check import CheckPanel, choose_sizes
from .notice import errors_shown, shown
from .panel import Panel, fit_columns, show
from .qt import QT_TRANSLATE_NOOP, QtCore, QtWidgets, translate
from .run import LIVE, assign, call, named
from .units import short

_MATERIALS = {
    "material_membrane": QT_TRANSLATE_NOOP("CurveUpsSolve", "Membrane"),
    "material_glue": QT_TRANSLATE_NOOP("CurveUpsSolve", "Glue"),
    "material_tile": QT_TRANSLATE_NOOP("CurveUpsSolve", "Material of tiles"),
}
# Parameters of the process window.
_RANGES = {
    "front_over_back": QT_TRANSLATE_NOOP("CurveUpsSolve", "Front over back"),
    "friction_coefficient": QT_TRANSLATE_NOOP("CurveUpsSolve", "Friction"),
}
_MOST = 6  # reasons, and warnings
_DONE, _RUNNING = "✓", "▶"


class SolvePanel(Panel):
    """Parameters, runs, verdict and process window of a design."""

    def __init__(self, design: Any):
        super().__init__(design, "solve")
        self._ranges: Any = None  # the process window that is shown, and its schema of units
        self._began: dict[str, float] = {}  # by stage
        self._stage, self._line = "", None  # type: str, Any
        form = self.form
        form.target.setText(_target(design))
        self.on_clicks(check=lambda: show(CheckPanel, design))
        self.reasons["check"] = partial(run.reason, "check", design)
        for which in ("solve", "verify", "repair"):
            self.on_clicks(**{which: partial(self.run, which)})
            self.reasons[which] = partial(run.reason, which, design)
        self.reasons["parameters"] = lambda: LIVE.obstacle() if LIVE.runs_on(design) else ""
        form.live.setChecked(preferences.draws_live())
        form.live.toggled.connect(lambda on: preferences.group().SetBool("DrawLive", bool(on)))
        fit_columns(form.stages, 0)
        form.stages.hide()
        form.stages.setFixedHeight(8 * form.stages.fontMetrics().height())
        fit_columns(form.window, 0)
        # The tiles that fail first beyond the end that is clicked.
        form.window.itemClicked.connect(
            lambda item, column: self.go_to(item.data(column, QtCore.Qt.UserRole) or []))
        self._prepare_parameters()
        self.follow()

    def end(self) -> None:
        if self.form is not None and not self._overlay.closed:
            self._rows.flush()
        self._rows.close()

    def run(self, which: str) -> None:
        """Start a run: "solve", "tile_anew", "verify", "repair", "build_solids"."""
        self._rows.flush()
        self.say("")
        self.form.stages.clear()
        self.form.stages.hide()
        self._began, self._line = {}, None
        with errors_shown(which):
            run.start(which, self.design)

    def turn_to(self, name: str) -> None:
        """Show a group of parameters, if there is one of that name."""
        number = self.form.group.findData(name)
        if number >= 0:
            self.form.group.setCurrentIndex(number)

    def _prepare_parameters(self) -> None:
        form = self.form
        self._groups: dict[str, list[str]] = {}
        for row in properties.rows():
            name = properties.property_name(row.name)
            if name in self.design.PropertiesList:
                self._groups.setdefault(row.group, []).append(name)
        for group in filter(self._groups.get, properties.GROUPS):
            form.group.addItem(translate("CurveUpsSolve", group), group)
        form.all.setChecked(preferences.group().GetBool("AllParameters", False))
        self._rows = self._make_rows()
        form.group.currentIndexChanged.connect(lambda *_: self._show_group())
        form.all.toggled.connect(lambda on: self._show_all(bool(on)))
        names = [name for group in self._groups.values() for name in group]
        self.on_clicks(remember=lambda: preferences.remember(self.design, names))
        menu = _menu(form.profile)
        for name in ("", *profiles.profile_names()):
            tip = profiles.about(profiles.profile_path(name)) if name else translate(
                "CurveUpsSolve", "Set the defaults of all parameters that a profile sets")
            _add(menu, name.upper() or translate("CurveUpsSolve", "Standard"), tip,
                 partial(self._apply, "actions.apply_profile", name))
        menu = _menu(form.materials)
        for kind, title in _MATERIALS.items():
            menu.addSection(translate("CurveUpsSolve", title))
            for name in profiles.material_names(kind):
                _add(menu, name, profiles.about(profiles.material_path(name)),
                     partial(self._apply, "actions.apply_material", kind, name)).setCheckable(True)
        menu.aboutToShow.connect(lambda: self._tick_materials(menu))

    def _tick_materials(self, menu: Any) -> None:
        values = properties.values_of(self.design)
        for action in menu.actions():
            if action.isCheckable():
                material = profiles.parameters(profiles.material_path(action.text()))
                action.setChecked(all(properties.same(values[name], value)
                                      for name, value in material.items()))

    def _apply(self, function: str, *names: str) -> None:
        self._rows.flush()
        with errors_shown(translate("CurveUpsSolve", "Parameters")):
            call(function, named(self.design), *map(repr, names))

    def _automatic(self, name: str) -> Any:
        """The button beside a size that looks for the largest value of a valid design."""
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
        self.say("")
        choose_sizes(self.design, (name,))

    def _show_group(self) -> None:
        self._rows.flush()
        self._rows.close()
        self._rows = self._make_rows()

    def _show_all(self, on: bool) -> None:
        preferences.group().SetBool("AllParameters", on)
        self._show_group()

    def _make_rows(self) -> ParameterRows:
        names = self._groups.get(self.form.group.currentData(), [])
        basic = [name for name in names if (row := properties.parameter_of(name)) and row.basic]
        self.form.all.setVisible(0 < len(basic) < len(names))
        if basic and not self.form.all.isChecked():
            names = basic
        beside: dict[str, Callable[[], Any]] = {
            properties.property_name(name): partial(self._automatic, name) for name in AUTOMATIC}
        return ParameterRows(self.form.rows, self.design, names, beside)

    def show(self) -> None:
        state = self.design.Status
        words = {EMPTY: (), RUNNING: (RUNNING,), CURRENT: (self.design.Verdict, self.design.Holds)}.get(
            state, (state, self.design.Holds))
        head = ", ".join(translate("CurveUpsSolve", word) for word in words)
        status = status_of(self.design)
        lines = list(map(shown, status.reasons[:_MOST]))
        if status.state in (CURRENT, INVALID) and status.parts["Layout"][0] == CURRENT:
            lines += [*self._tiling(), *self._warnings()]
        if getattr(self.design, "Kit", "").startswith(OUT_OF_DATE):
            lines.append(translate("CurveUpsSolve", "The fabrication kit is out of date"))
        title = ": ".join(filter(None, (self.design.Label, head)))
        self.form.verdict.setText(f"<b>{escape(title)}</b>"
                                  + "".join(f"<br>{line}" for line in lines))
        self._show_window()
        self._rows.show()

    def _tiling(self) -> list[str]:
        """Line on tiles that follow earlier ones; others are warned of."""
        tiles = stored(self.design).latest("target") if self.design.Tiling else None
        return [shown(tiles.tiling)] if tiles and tiles.followed_along else []

    def _warnings(self) -> list[str]:
        """The first warning of each kind."""
        warnings = first_of_each_kind(warnings_of(self.design))
        more = translate("CurveUpsSolve", " ({count} more)")
        return [translate("CurveUpsSolve", "Warning: {what}", what=shown(finding))
                + (more.format(count=others) if others else "") for finding, others in warnings[:_MOST]]

    def _show_window(self) -> None:
        """Show the process window of a design that holds, if its run looked for one."""
        tree, settled = self.form.window, stored(self.design).latest("settle")
        ranges = settled.window if settled and self.design.Holds == HOLDS[True] else ()
        if (ranges, FreeCAD.Units.getSchema()) == self._ranges:
            return
        self._ranges = ranges, FreeCAD.Units.getSchema()
        tree.clear()
        for row in ranges:
            name = translate("CurveUpsSolve", _RANGES.get(row.parameter, row.parameter))
            item = QtWidgets.QTreeWidgetItem(tree, [name])
            item.setToolTip(0, name)
            for column, (mark, end, searched, failure) in enumerate(
                    zip("≤≥", row.ends, row.searched, row.failures), 1):
                item.setText(column, f"{mark} {_value(row, searched)}" if end is None else _value(row, end))
                item.setTextAlignment(column, QtCore.Qt.AlignRight)
                if failure:
                    item.setToolTip(column, shown(failure, False))
                    item.setData(column, QtCore.Qt.UserRole, list(failure.tiles))
        tree.setVisible(bool(ranges))
        tree.setFixedHeight(tree.header().sizeHint().height() + len(ranges) * tree.sizeHintForRow(0) + 4)

    def run_changed(self, status: Status, running: bool) -> None:
        """Show a line for each stage that has begun, with its seconds."""
        tree, now, stage = self.form.stages, time.perf_counter(), status.stage if running else ""
        self.form.at_work.setVisible(running)
        if self._line is not None and stage != self._stage:
            _mark(self._line, _DONE, self._line.text(0)[2:])
            self._line.setText(1, f"{now - self._began[self._stage]:.1f} s")
            self._line = None
        if stage and stage not in self._began:
            self._began[stage], self._line = now, QtWidgets.QTreeWidgetItem(tree)
            _mark(self._line, _RUNNING, translate("CurveUpsSolve", label_of(stage)))
            self._line.setTextAlignment(1, QtCore.Qt.AlignRight)
            tree.show()
            tree.scrollToItem(self._line)
        if self._line is not None:
            self._line.setText(1, f"{now - self._began[stage]:.0f} s")
        self._stage = stage


def _target(design: Any) -> str:
    """Name of the target, with the faces that are chosen."""
    target = design.Target
    source = getattr(target, "Source", None)
    name = source.Label if source is not None else (
        getattr(target, "BuiltIn", "") or Path(getattr(target, "File", "")).name)
    return translate("CurveUpsSolve", "Target: {name}", name=" ".join(filter(None, (name, design.Faces))))


def let_it_need_little_friction(design: Any) -> None:
    """Set SelfShaping, and repair the layout."""
    title = translate("CurveUps_LittleFriction", "Let It Need Little Friction")
    with transaction(design.Document, title):
        assign(design, "SelfShaping", True)
    show(SolvePanel, design).run("repair")


def _value(row: Range, value: float) -> str:
    """A value of the process window, with its unit."""
    return f"{short(value)} {row.unit}".rstrip()


def _mark(item: Any, mark: str, stage: str) -> None:
    """Name a stage, also in a tooltip: the name may be wider than the dock."""
    item.setText(0, f"{mark} {stage}")
    item.setToolTip(0, item.text(0))


def _menu(button: Any) -> Any:
    menu = QtWidgets.QMenu(button)
    menu.setToolTipsVisible(True)
    button.setMenu(menu)
    return menu


def _add(menu: Any, text: str, tip: str, work: Callable[[], object]) -> Any:
    action = menu.addAction(text)
    action.setToolTip(tip)
    action.triggered.connect(lambda *_: work())
    return action
