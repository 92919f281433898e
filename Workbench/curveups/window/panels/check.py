# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Check: margins of the target's tiles, what is in their way, and sizes that work."""

from __future__ import annotations

from html import escape
from textwrap import fill
from typing import Any, Mapping, Optional

from ...base.errors import CurveUpsError, tile_name
from ...base.parameters import parameter
from ...base.sentences import ESTIMATE, MARGINS
from ...features import actions, document, properties
from ...features.actions import transaction
from ...project.project import Results
from ...project.size_choice import SizeChoice
from ...project.worker import Status
from ...report import check as words
from ...stages import asked_by
from .. import runs
from ..notice import errors_shown, show_line, shown, words_of
from ..qt import QT_TRANSLATE_NOOP, QtCore, QtWidgets, translate
from ..run import LIVE, Task
from ..runs import assign
from ..units import in_user_units
from .panel import Panel, enable

_MOST, _LETTERS = 300, 24  # obstacles; letters in a line
# The fields of the overlay that show the margins.
_FIELDS = dict(zip(MARGINS, ("Dihedral margin", "Dihedral margin", "Pin area margin", "Pin area margin",
                             "Membrane clearance", "Membrane clearance", "Conformal stretch",
                             "Conformal stretch", "Obstacles")))


class CheckPanel(Panel):
    """While it is open the overlay shows the target instead of a layout. What was
    checked under other values stands there as out of date until it is checked again."""

    def __init__(self, design: Any):
        super().__init__(design, "check", translate("CurveUps_Check", "Check of {name}", name=design.Label))
        self._found: Optional[Results] = None
        self._drawn: Any = None
        form = self.form
        form.margins.setHeaderLabels([translate("CurveUps_Check", text) for text in _HEAD])
        form.obstacles.setHeaderLabels([translate("CurveUps_Check", "Tile"),
                                        translate("CurveUps_Check", "Obstacles")])
        form.margins.header().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        form.obstacles.header().setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        self._on_clicks(check=self.check, find=self._find, choose=self._choose,
                        use_length=lambda: self._use("L"), use_thickness=lambda: self._use("H_body"))
        form.margins.itemSelectionChanged.connect(lambda: self._show_margin())
        form.obstacles.itemSelectionChanged.connect(lambda: self._go())
        self._follow()
        self._overlay.show_target(True)
        if not self._is_current():
            self.check()

    def close(self) -> None:
        super().close()
        if not self._overlay.closed:
            if LIVE.runs_on(self.design):
                LIVE.cancel()
            self._overlay.show_target(False)

    def check(self) -> None:
        """Starts the run, on the worker."""
        self._say("")
        self._start()

    def _start(self) -> None:
        with errors_shown(translate("CurveUps_Check", "Check")):
            runs.start("check", self.design)

    def _find(self) -> None:
        self._say("")
        with errors_shown(translate("CurveUps_Check", "Find Sizes")):
            runs.start("find_sizes", self.design, self._fill)

    def show(self) -> None:
        """The overlay has changed, which it does with every change of the design."""
        scene, note = self._overlay.scene, self._overlay.note
        if scene is not None:
            self._uncover()
        if self._drawn is None or self._drawn[0] is not scene or self._drawn[1] != note:
            self._drawn = scene, note
            self._fill()

    # What was found.

    def _is_current(self) -> bool:
        try:
            project = document.project_of(self.design)
        except CurveUpsError:
            return False
        return project.out_of_date("feasibility") == ()

    def _fill(self) -> None:
        form, current = self.form, self._is_current()
        if current:
            project = document.project_of(self.design)
            goals = asked_by("check", *(("sizes",) if project.out_of_date("sizes") == () else ()))
            self._found = project.run(goals)  # nothing is made anew
        found = self._found
        for part in (form.sizes, form.margins, form.obstacles, form.note):
            part.setVisible(found is not None)
        form.left.setVisible(False)
        self._show_running(LIVE.runs_on(self.design))
        if found is None:
            form.verdict.setText("")
            return
        head = translate("CurveUps_Check", "Feasible") if found["feasibility"].feasible else translate(
            "CurveUps_Check", "Not feasible")
        if not current:
            head = translate("CurveUps_Check", "Out of date: check again")
        said = [shown(one) for one in words.verdict(found)]
        form.verdict.setText(f"<b>{escape(head)}</b><br>{', '.join(said)}")
        self._fill_sizes(found)
        self._fill_margins(found)
        self._fill_obstacles(found)

    def _fill_sizes(self, found: Results) -> None:
        form, known = self.form, "sizes" in found
        form.find.setVisible(not known)
        form.advice.setVisible(known)
        form.advice.setText("\n".join(shown(one, False) for one in words.advice(found)) if known else "")
        for name, button in (("L", form.use_length), ("H_body", form.use_thickness)):
            sizes = sizes_to_use(name, found)
            button.setVisible(bool(sizes))
            button.setText(translate("CurveUps_Check", "Use {sizes}", sizes=_words_of_sizes(sizes)))

    def _fill_margins(self, found: Results) -> None:
        tree = self.form.margins
        tree.clear()
        for figure in found["feasibility"].figures:
            head, number = in_user_units(words_of(figure.name))
            _, worst, tile, *cells = words.row(figure, found["feasibility"].blocked, number)
            top = QtWidgets.QTreeWidgetItem(tree, [fill(head, _LETTERS)])
            top.setFirstColumnSpanned(True)
            top.setExpanded(True)
            values = QtWidgets.QTreeWidgetItem(top, [f"{worst}\n{tile}".strip(), *cells])
            for item in (top, values):
                item.setData(0, QtCore.Qt.UserRole, (_FIELDS[figure.name], tile))
        self.form.note.setText(words_of(ESTIMATE))

    def _fill_obstacles(self, found: Results) -> None:
        form, blocked = self.form, found["feasibility"].blocked
        form.obstacles.clear()
        for one in blocked[:_MOST]:
            why = shown(one.why, False)
            text = fill(why if one.certain else f"{why} *", _LETTERS)
            item = QtWidgets.QTreeWidgetItem([tile_name(one.tile), text])
            item.setToolTip(1, why)
            item.setData(0, QtCore.Qt.UserRole, one.tile)
            form.obstacles.addTopLevelItem(item)
        form.obstacles.setVisible(bool(blocked))
        form.left.setVisible(len(blocked) > _MOST)
        form.left.setText(translate("CurveUps_Check", "and {count} more", count=len(blocked) - _MOST))

    # What is done with it.

    def _show_margin(self) -> None:
        for item in self.form.margins.selectedItems():
            name, tile = item.data(0, QtCore.Qt.UserRole)
            if name in self._overlay.fields():
                self._overlay.set_field(name)
            if tile:
                self._look_at([int(tile[1:]) - 1])

    def _go(self) -> None:
        chosen = [item.data(0, QtCore.Qt.UserRole) for item in self.form.obstacles.selectedItems()]
        if chosen:
            self._look_at(chosen)

    def _look_at(self, tiles: list[int]) -> None:
        scene = self._overlay.scene
        if scene is not None and max(tiles) < len(scene.F):
            self._overlay.select_tiles(tiles)
            self._overlay.look_at(tiles)

    def _use(self, name: str) -> None:
        """Takes over what a size's button offers, one step of undo, and checks it."""
        if self._found is not None:
            self._set(sizes_to_use(name, self._found))

    def _set(self, values: Mapping[str, Any]) -> None:
        called = ", ".join(map(properties.property_name, values))
        with errors_shown(translate("CurveUps_Check", "Check")):
            actions.refuse_bound(self.design, tuple(values))
            with transaction(self.design.Document, translate("CurveUps_Check", "Use {name}", name=called)):
                for name, value in values.items():
                    assign(self.design, properties.property_name(name), value)
                self.design.Document.recompute()
            self.check()

    def _choose(self) -> None:
        self._say("")
        choose_sizes(self.design, ("L", "H_body"), self._start)

    # What is going on.

    def _show_running(self, mine: bool) -> None:
        form = self.form
        old = "" if self._is_current() else translate("CurveUps_Check", "Out of date: check again")
        enable(form.check, runs.reason("check", self.design))
        enable(form.sizes, LIVE.obstacle() or old)
        for part in (form.progress, form.doing):
            part.setVisible(mine)

    def _show_run(self, status: Status, goes_on: bool) -> None:
        mine = goes_on and LIVE.runs_on(self.design)
        if not goes_on or self.form.check.isEnabled() == LIVE.busy:
            self._show_running(mine)


_HEAD = (QT_TRANSLATE_NOOP("CurveUps_Check", "Worst"),
         QT_TRANSLATE_NOOP("CurveUps_Check", "Needed"),
         QT_TRANSLATE_NOOP("CurveUps_Check", "Below"))


def choose_sizes(design: Any, names: tuple[str, ...], told: Any = None) -> None:
    """Starts solving for sizes, the largest first; the first of which a design is valid are set, one step of
    undo, and `told` is called then."""
    title = translate("CurveUps_Check", "Choose Sizes")

    def finish(obj: Any, found: SizeChoice) -> None:
        runs.finish("choose_sizes", obj, found, repr(names))
        obj.Document.recompute()
        show_line("; ".join(shown(one, False) for one in found.findings()))

    with errors_shown(title):
        LIVE.start(design, Task(title, actions.sizes_work(design, names), finish, told=told))


def sizes_to_use(name: str, found: Results) -> dict[str, float]:
    """Nearest limit of L and of H_body, which their buttons offer where the sizes set are not feasible."""
    if "sizes" not in found or found["feasibility"].feasible:
        return {}
    sizes = found["sizes"]
    value = sizes.H_body if name == "H_body" else sizes.L and sizes.L[0]
    return {} if value is None else {name: value}


def _words_of_sizes(values: Mapping[str, float]) -> str:
    return ", ".join(f"{properties.property_name(name)} = {properties.shown(parameter(name), value)}"
                     for name, value in values.items())
