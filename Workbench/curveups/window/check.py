# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check: margins of the target's tiles, obstacles, and sizes that work."""

from __future__ import annotations

from html import escape
from textwrap import fill
from typing import Any, Optional

import FreeCAD

from ..base.errors import CurveUpsError, tile_name
from ..base.parameters import parameter
from ..base.sentences import MARGINS
from ..features import actions, document, properties
from ..features.actions import transaction
from ..project.project import Results
from ..project.size_choice import SizeChoice
from ..report import check as report
from ..stages import stages_of
from . import run
from .notice import errors_shown, show_line, shown, words_of
from .panel import Panel, fit_columns, put
from .qt import QT_TRANSLATE_NOOP, QtCore, QtWidgets, translate
from .run import LIVE, Task, assign
from .units import in_user_units

_MOST, _LETTERS = 300, 24  # obstacles; letters in a line
# Short titles of the margins, and the fields of the overlay that show them.
_SHORT = dict(zip(MARGINS, (
    QT_TRANSLATE_NOOP("CurveUps_Check", "Fold"), QT_TRANSLATE_NOOP("CurveUps_Check", "Back / front"),
    QT_TRANSLATE_NOOP("CurveUps_Check", "Front pin"), QT_TRANSLATE_NOOP("CurveUps_Check", "Back pin"),
    QT_TRANSLATE_NOOP("CurveUps_Check", "Front membrane"),
    QT_TRANSLATE_NOOP("CurveUps_Check", "Back membrane"),
    QT_TRANSLATE_NOOP("CurveUps_Check", "Least stretch"), QT_TRANSLATE_NOOP("CurveUps_Check", "Most stretch"),
    QT_TRANSLATE_NOOP("CurveUps_Check", "Overlaps"))))
_FIELDS = dict(zip(MARGINS, ("Dihedral margin", "Dihedral margin", "Pin area margin", "Pin area margin",
                             "Membrane clearance", "Membrane clearance", "Conformal stretch",
                             "Conformal stretch", "Obstacles")))


class CheckPanel(Panel):
    """Results of a check. The overlay meanwhile shows the target instead of a layout. A check of other values
    is shown as out of date until the next one."""

    def __init__(self, design: Any):
        super().__init__(design, "check")
        self._results: Optional[Results] = None
        self._drawn: tuple = ()
        self._tasks: list[Task] = []  # that this panel has started
        form = self.form
        fit_columns(form.margins, 0)
        fit_columns(form.obstacles)
        self.on_clicks(check=self.check, find=self._find, choose=self._choose,
                       use_length=lambda: self._use("L"), use_thickness=lambda: self._use("H_body"))
        self.reasons.update(check=lambda: run.reason("check", design),
                            sizes=lambda: LIVE.obstacle() or self._out_of_date())
        form.margins.itemSelectionChanged.connect(lambda: self._show_margin())
        form.obstacles.itemSelectionChanged.connect(lambda: self.go_to(
            [item.data(0, QtCore.Qt.UserRole) for item in form.obstacles.selectedItems()]))
        self.follow()
        self._overlay.show_target(True)
        if self._out_of_date():
            self.check()

    def end(self) -> None:
        if not self._overlay.closed:
            LIVE.withdraw(self._tasks, silent=False)
            self._overlay.show_target(False)

    def check(self) -> None:
        """Start the run."""
        self.say("")
        self._start()

    def _start(self) -> None:
        with errors_shown(translate("CurveUps_Check", "Check")):
            self._tasks.append(run.start("check", self.design))

    def _find(self) -> None:
        self.say("")
        with errors_shown(translate("CurveUps_Check", "Find Sizes")):
            self._tasks.append(run.start("find_sizes", self.design, self._fill))

    def show(self) -> None:
        scene = self._overlay.scene
        if scene is not None:
            self.uncover()
        drawn = id(scene), self._overlay.note, FreeCAD.Units.getSchema()
        if drawn != self._drawn:
            self._drawn = drawn
            self._fill()

    def _out_of_date(self) -> str:
        try:
            if document.project_of(self.design).out_of_date("feasibility") == ():
                return ""
        except CurveUpsError:
            pass
        return translate("CurveUps_Check", "Out of date: check again")

    def _fill(self) -> None:
        form, out_of_date = self.form, self._out_of_date()
        if not out_of_date:
            project = document.project_of(self.design)
            goals = stages_of("check", *(("sizes",) if project.out_of_date("sizes") == () else ()))
            self._results = project.run(goals)  # they are known: nothing is computed
        results = self._results
        for part in (form.verdict, form.sizes, form.margins, form.obstacles, form.left):
            part.setVisible(results is not None)
        if results is None:
            return
        feasible = (translate("CurveUps_Check", "Feasible") if results["feasibility"].feasible
                    else translate("CurveUps_Check", "Not feasible"))
        verdict = ", ".join(map(shown, report.verdict(results)))
        form.verdict.setText(f"<b>{escape(out_of_date or feasible)}</b><br>{verdict}")
        self._fill_sizes(results)
        self._fill_margins(results)
        self._fill_obstacles(results)
        self.show_reasons()

    def _fill_sizes(self, results: Results) -> None:
        form, known = self.form, "sizes" in results
        form.find.setVisible(not known)
        put(form.advice, "\n".join(shown(finding, False) for finding in report.advice(results))
            if known else "")
        for name, button in (("L", form.use_length), ("H_body", form.use_thickness)):
            size = _size_to_use(name, results)
            button.setVisible(size is not None)
            if size is not None:
                text = f"{properties.property_name(name)} = {properties.shown(parameter(name), size)}"
                button.setText(translate("CurveUps_Check", "Use {sizes}", sizes=text))

    def _fill_margins(self, results: Results) -> None:
        tree = self.form.margins
        tree.clear()
        for figure in results["feasibility"].figures:
            head, number = in_user_units(words_of(figure.name))
            _, worst, tile, _, short = report.row(figure, results["feasibility"].blocked, number)
            needed = number(figure.needed, "g")
            item = QtWidgets.QTreeWidgetItem(tree, [
                translate("CurveUps_Check", _SHORT[figure.name]),
                worst + " ✗" * (short != "0"),
                f"≈ {needed}" if figure.estimate else needed])
            tip = translate("CurveUps_Check",
                            "{margin}: the worst tile is {tile}; tiles short of it: {count}",
                            margin=head, tile=tile or "–", count=short)
            for column in range(tree.columnCount()):
                item.setToolTip(column, tip)
            item.setData(0, QtCore.Qt.UserRole, (_FIELDS[figure.name], tile))
        tree.setFixedHeight(tree.header().sizeHint().height() + tree.topLevelItemCount()
                            * tree.sizeHintForRow(0) + 4)

    def _fill_obstacles(self, results: Results) -> None:
        form, blocked = self.form, results["feasibility"].blocked
        form.obstacles.clear()
        for obstacle in blocked[:_MOST]:
            why = shown(obstacle.why, False)
            item = QtWidgets.QTreeWidgetItem(form.obstacles, [
                tile_name(obstacle.tile), fill(why if obstacle.certain else translate(
                    "CurveUps_Check", "likely: {why}", why=why), _LETTERS)])
            item.setToolTip(1, why)
            item.setData(0, QtCore.Qt.UserRole, obstacle.tile)
        form.obstacles.setVisible(bool(blocked))
        put(form.left, translate("CurveUps_Check", "and {count} more", count=len(blocked) - _MOST)
            if len(blocked) > _MOST else "")

    def _show_margin(self) -> None:
        for item in self.form.margins.selectedItems():
            name, tile = item.data(0, QtCore.Qt.UserRole)
            if name in self._overlay.fields():
                self._overlay.set_field(name)
            if tile:
                self.go_to([int(tile[1:]) - 1])

    def _use(self, name: str) -> None:
        """Set the size that its button offers, as one step of undo, and check it."""
        size, shown_name = _size_to_use(name, self._results), properties.property_name(name)
        with errors_shown(translate("CurveUps_Check", "Check")):
            actions.refuse_bound(self.design, (name,))
            with transaction(self.design.Document,
                             translate("CurveUps_Check", "Use {name}", name=shown_name)):
                assign(self.design, shown_name, size)
                self.design.Document.recompute()
            self.check()

    def _choose(self) -> None:
        self.say("")
        self._tasks += choose_sizes(self.design, ("L", "H_body"), self._start)


def choose_sizes(design: Any, names: tuple[str, ...], done: Any = None) -> list[Task]:
    """Start solving for sizes, the largest first, and set the first with a valid design, as one step of undo.
    `done` is called then. Return the task, or none where it can't start."""
    title = translate("CurveUps_Check", "Choose Sizes")

    def finish(obj: Any, choice: SizeChoice) -> None:
        run.finish("choose_sizes", obj, choice, repr(names))
        obj.Document.recompute()
        show_line("; ".join(shown(finding, False) for finding in choice.findings()))

    tasks: list[Task] = []
    with errors_shown(title):
        tasks.append(Task(title, actions.sizes_work(design, names), finish, told=done))
        LIVE.start(design, tasks[0])
    return tasks


def _size_to_use(name: str, results: Optional[Results]) -> Optional[float]:
    """The limit of L or H_body that is nearest to an infeasible value, if there is one."""
    if results is None or "sizes" not in results or results["feasibility"].feasible:
        return None
    sizes = results["sizes"]
    return sizes.H_body if name == "H_body" else sizes.L and sizes.L[0]
