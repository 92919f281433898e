# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts: edges are picked in the view, each click is a step of undo, and the layout follows."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Any, Callable, Iterable, Optional

import FreeCAD
import numpy as np

from ..base.errors import CurveUpsError
from ..features import document
from ..features.actions import transaction
from ..features.status import CURRENT, status_of
from ..project.worker import Status
from ..stages.cut_request import CutRequest
from ..stages.stage import Job
from . import run
from .cut_paths import CutPaths, Edge, groups
from .notice import errors_shown, rich
from .overlay.picking import CutLines, Pick, PickTool
from .panel import Panel, fit_columns, put
from .qt import QtCore, QtWidgets, translate
from .run import LIVE, Task, call, named


class CutLayout:
    """Layouts of a Design with other cuts, on a copy of its project. They are shown, not stored. of_target:
    the design has no layout of the present target."""

    def __init__(self, design: Any, project: Any):
        self._design, self._project = design, project
        V, F = np.asarray(project.latest("target smoothing").V), np.asarray(project.latest("target").F)
        finished = project.latest("design")
        self.of_target = finished is None or not np.array_equal(finished.design.F, F)
        # Layouts stay where the camera looks, and as they lay: as the one before, else as the target.
        self._before = V[F][..., :2] if self.of_target else np.asarray(finished.design.T)
        self._last: Optional[tuple[np.ndarray, np.ndarray]] = None
        self._tasks: list[Task] = []  # the last one
        self.seconds = 0.0

    def start(self, edges: np.ndarray, done: Callable[[], None]) -> None:
        """Lay out with these cuts, C x 2, and those of pieces, in place of a layout that runs already.
        `done` is called in the window's thread after the run's end."""
        self.stop()
        begin, twin = time.perf_counter(), self._project.copy()
        twin.give("cut request", CutRequest(edges=np.asarray(edges, np.int32).reshape(-1, 2)))

        def work(job: Job) -> Any:
            listen = job.listen
            if listen is not None:
                tell = listen
                job.listen = lambda stage, T, *others: tell(stage, self._in_sight(T), *others)
            design = twin.run(("layout",), job)["layout"].design
            return self._in_sight(design.T), design.q

        def finish(design: Any, layout: Any) -> None:
            self._last, self._before = layout, layout[0]
            self.seconds = time.perf_counter() - begin

        self._tasks = [Task(translate("CurveUps_Cuts", "Lay out"), work, finish, told=done)]
        LIVE.start(self._design, self._tasks[0])

    def stop(self) -> None:
        """Stop a layout that runs."""
        LIVE.withdraw(self._tasks)

    def show(self, overlay: Any) -> None:
        """Draw the last layout."""
        if self._last is not None:
            overlay.set_iterate(*self._last, note=translate("CurveUps_Cuts", "layout with these cuts"))

    def _in_sight(self, T: np.ndarray) -> np.ndarray:
        return aligned(T, self._before)


def aligned(T: np.ndarray, before: np.ndarray) -> np.ndarray:
    """Move and turn flat tiles (M x 3 x 2) in their plane, so that they lie near others by least squares."""
    middle, to = T.mean((0, 1)), before.mean((0, 1))
    (xx, xy), (yx, yy) = np.einsum("mki,mkj->ij", T - middle, before - to)
    angle = np.arctan2(xy - yx, xx + yy)
    c, s = np.cos(angle), np.sin(angle)
    return (T - middle) @ np.array([[c, s], [-s, c]]) + to


class CutsPanel(Panel):
    """Cuts of a design, and suggestions for more."""

    def __init__(self, design: Any):
        super().__init__(design, "cuts")
        form = self.form
        self._paths: Optional[CutPaths] = None
        self._tip: Optional[int] = None      # vertex from which the next click continues
        self._preview: list[Edge] = []
        self._listed: Any = None             # cuts in the list, and its schema of units
        self._search: Any = None
        self._layout: Optional[CutLayout] = None
        self._tasks: list[Task] = []  # that this panel has started, but for layouts
        self._lines = CutLines(self._overlay)
        self._tool: Optional[PickTool] = None
        self.on_clicks(anew=self._begin_anew, remove=self._remove, suggest=self._suggest,
                       accept=self._accept)
        self.reasons.update(suggest=LIVE.obstacle, accept=self._no_suggestion, anew=self._no_path,
                            remove=self._no_cuts)
        form.live.toggled.connect(lambda on: self._lay_out() if on else self._stop_layout())
        form.cuts.itemSelectionChanged.connect(lambda: self._draw())
        form.suggested.itemSelectionChanged.connect(lambda: self._show_suggestion())
        form.suggested.setVisible(False)
        fit_columns(form.cuts)
        self.follow()
        FreeCAD.addDocumentObserver(self)
        with errors_shown(translate("CurveUps_Cuts", "Cuts")):
            self._prepare()

    def end(self) -> None:
        FreeCAD.removeDocumentObserver(self)
        self._stop_layout()
        LIVE.withdraw(self._tasks)
        if self._tool is not None:
            self._tool.close()
        if not self._overlay.closed:
            self._lines.close()
            self._overlay.shows_target = False
            self._overlay.show_design()

    def show(self) -> None:
        """Follow the overlay, and cuts that undo, redo and scripts change."""
        if self._overlay.scene is not None:
            self.uncover()
        if self._paths is not None:
            cuts, before = tuple(self._edges()), self._listed
            self._listed = cuts, FreeCAD.Units.getSchema()
            if self._listed != before:
                self._list(cuts)
                if before is not None and before[0] != cuts:
                    self._lay_out()
        self._draw()

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """Notice a change of the cuts, called by FreeCAD."""
        if name == "Edges" and not self._overlay.closed and obj == self.design.Cuts:
            self._later.start(0)

    def _prepare(self) -> None:
        """Begin on the target whose edges are picked, which may have to be made first."""
        project = document.project_of(self.design)
        if project.out_of_date("target smoothing") == ():
            self._begin(project)
            return
        self.say(translate("CurveUps_Cuts", "The target is being divided into tiles: click edges after that"))
        self._tasks.append(run.start("divide", self.design,
                                     lambda: self._begin(document.project_of(self.design))))

    def _begin(self, project: Any) -> None:
        self._paths = CutPaths(project.latest("target smoothing").V, project.latest("target").F)
        self._layout = CutLayout(self.design, project)
        self._tool = PickTool(self.design, self._hover, self._click, self._begin_anew)
        self._overlay.show_target(self._layout.of_target)
        self.say("")
        self.update()

    def _edges(self) -> list[Edge]:
        """Cuts of the design; none, and a message, where the property has no edges of the target."""
        try:
            return [(min(edge), max(edge)) for edge in document.cuts_of(self.design).tolist()]
        except CurveUpsError as error:
            self.say(rich(error))
            return []

    def _set(self, edges: Iterable[Edge], what: str) -> None:
        """Set the cuts, as one step of undo."""
        cuts = [[int(a), int(b)] for a, b in dict.fromkeys(edges)]
        with errors_shown(what), transaction(self.design.Document, what):
            call("document.set_cuts", named(self.design), repr(cuts))
        self.say("")
        self.update()

    # The mouse.

    def _reach(self, picked: Optional[Pick]) -> tuple[list[Edge], Optional[int]]:
        """Edges that a click cuts, and the vertex from which the next one continues."""
        if picked is None or self._paths is None or not self._shows_target():
            return [], self._tip
        a, b = picked.vertices
        if self._tip is None:  # the first path continues from the nearer end
            distances = np.linalg.norm(picked.ends - picked.point, axis=1)
            a, b = (a, b) if distances[1] < distances[0] else (b, a)
        return self._paths.reach((a, b), self._tip)

    def _shows_target(self) -> bool:
        """True where the tiles in the view are those whose edges are cut."""
        scene = self._overlay.scene
        return scene is not None and self._paths is not None and np.array_equal(scene.F, self._paths.F)

    def _hover(self, picked: Optional[Pick]) -> None:
        preview = self._reach(picked)[0]
        if picked is not None and _edge_of(picked) in self._edges():
            preview = [_edge_of(picked)]
        if preview != self._preview:
            self._preview = preview
            self._draw()

    def _click(self, picked: Pick) -> None:
        self._preview = []
        with errors_shown(translate("CurveUps_Cuts", "Cuts")):
            edges, edge = self._edges(), _edge_of(picked)
            if edge in edges:
                self._tip = None
                self._set([other for other in edges if other != edge],
                          translate("CurveUps_Cuts", "Take a cut back"))
                return
            added, self._tip = self._reach(picked)
            if added:
                self._set([*edges, *added], translate("CurveUps_Cuts", "Cut"))
            else:
                self.say(translate("CurveUps_Cuts", "The rim is open already: click an edge inside"))

    def _begin_anew(self) -> None:
        """Let the next click start a new cut."""
        self._tip, self._preview = None, []
        self.update()

    # The list.

    def _list(self, edges: tuple[Edge, ...]) -> None:
        tree = self.form.cuts
        tree.clear()
        if self._tip is not None and not any(self._tip in edge for edge in edges):
            self._tip = None  # the cut that it ended was taken back
        for number, group in enumerate(groups(edges), 1):
            length = FreeCAD.Units.Quantity(self._paths.length(group), FreeCAD.Units.Length)  # type: ignore
            item = QtWidgets.QTreeWidgetItem(tree, [str(number), str(len(group)), length.UserString])
            item.setData(0, QtCore.Qt.UserRole, group)

    def _selected(self) -> list[Edge]:
        return [(a, b) for item in self.form.cuts.selectedItems()
                for a, b in item.data(0, QtCore.Qt.UserRole)]

    def _remove(self) -> None:
        removed = self._selected() or self._edges()
        self._tip = None
        self._set([edge for edge in self._edges() if edge not in removed],
                  translate("CurveUps_Cuts", "Remove cuts"))

    def _draw(self) -> None:
        if self._paths is None or self._overlay.closed:
            return
        kinds = {"hovered": self._preview, "selected": self._selected(), "suggested": self._suggested_edges(),
                 "cut": self._edges()}
        drawn: set[Edge] = set()  # an edge has one line: that of the first kind
        for kind, edges in kinds.items():
            kinds[kind] = [edge for edge in edges if edge not in drawn]
            drawn.update(edges)
        self._lines.draw(kinds)

    # Suggestions.

    def _suggest(self) -> None:
        self._stop_layout()
        title = translate("CurveUps_Cuts", "Suggest")
        with errors_shown(title):
            twin = document.project_of(self.design).copy()
            request = CutRequest(edges=document.cuts_of(self.design))
            twin.give("cut request", replace(request, suggested=self.form.most.value()))

            def finish(design: Any, search: Any) -> None:
                self._search = search
                self._list_suggestions()
                if not search.cuts:
                    self.say(translate("CurveUps_Cuts", "Found no cut that is worth making"))

            task = Task(title, lambda job: twin.run(("cut search",), job)["cut search"], finish)
            LIVE.start(self.design, task)
            self._tasks.append(task)

    def _list_suggestions(self) -> None:
        tree, cuts = self.form.suggested, self._search.cuts if self._search is not None else ()
        tree.clear()
        for cut in cuts:
            QtWidgets.QTreeWidgetItem(tree, [str(cut)]).setToolTip(0, str(cut))
        tree.setVisible(bool(cuts))
        if cuts:
            tree.setCurrentItem(tree.topLevelItem(0))

    def _show_suggestion(self) -> None:
        """Show the predicted gain in full, and the cuts in the view."""
        chosen = self._chosen()
        self.form.gain.setText(str(chosen[-1]) if chosen else "")
        self.update()

    def _chosen(self) -> list:
        """The selected suggestion, and those before it, on which it builds."""
        tree = self.form.suggested
        rows = [tree.indexOfTopLevelItem(item) for item in tree.selectedItems()]
        return list(self._search.cuts[:max(rows) + 1]) if rows and self._search is not None else []

    def _suggested_edges(self) -> list[Edge]:
        return [(min(edge), max(edge)) for cut in self._chosen() for edge in cut.edges.tolist()]

    def _accept(self) -> None:
        added = self._suggested_edges()
        self._search = None
        self._list_suggestions()
        self._set([*self._edges(), *added], translate("CurveUps_Cuts", "Accept suggested cuts"))

    # The layout that follows.

    def _lay_out(self) -> None:
        if self._layout is None or not self.form.live.isChecked() or not self._shows_target():
            return
        if status_of(self.design).parts["Layout"][0] == CURRENT:  # undo led back to its cuts
            self._stop_layout()
            self._overlay.show_design()
            put(self.form.doing, "")
            return
        with errors_shown(translate("CurveUps_Cuts", "Lay out")):
            self._layout.start(document.cuts_of(self.design), self._show_layout)

    def _show_layout(self) -> None:
        if self.form is None or self._overlay.closed or self._layout is None:
            return
        self._layout.show(self._overlay)
        put(self.form.doing, translate(
            "CurveUps_Cuts", "Layout in {seconds:.1f} s. Solve repairs and verifies it.",
            seconds=self._layout.seconds))
        self._draw()

    def _stop_layout(self) -> None:
        if self._layout is not None:
            self._layout.stop()

    def run_changed(self, status: Status, running: bool) -> None:
        if running:
            self._draw()

    # Reasons why buttons are disabled.

    def _no_suggestion(self) -> str:
        return "" if self._chosen() else translate("CurveUps_Cuts",
                                                   "Click Suggest first, then select a cut")

    def _no_path(self) -> str:
        return "" if self._tip is not None else translate("CurveUps_Cuts",
                                                          "The next click already starts a new cut")

    def _no_cuts(self) -> str:
        return "" if self._edges() else translate("CurveUps_Cuts", "There are no cuts")


def _edge_of(picked: Pick) -> Edge:
    return min(picked.vertices), max(picked.vertices)
