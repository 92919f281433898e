# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Cuts: edges are picked in the view, each click a step of undo; the layout follows."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Any, Callable, Iterable, Optional

import FreeCAD
import numpy as np

from ...base.errors import CurveUpsError
from ...features import document
from ...features.actions import transaction
from ...project.worker import Status
from ...stages.cut_request import CutRequest
from ...stages.stage import Job
from .. import runs
from ..cut_paths import CutPaths, Edge, groups
from ..notice import errors_shown
from ..overlay.picking import CutLines, Pick, PickTool
from ..overlay.watching import unit_observers
from ..qt import QtCore, QtWidgets, translate
from ..run import LIVE, Task
from ..runs import call, named
from .panel import Panel, enable


class CutLayout:
    """Of a Design whose project has a target, mended where that is asked for."""

    def __init__(self, design: Any, project: Any):
        self._design, self._project = design, project
        V, F = np.asarray(project.latest("target smoothing").V), np.asarray(project.latest("target").F)
        finished = project.latest("design")
        has_layout = finished is not None and np.array_equal(finished.design.F, F)
        # Layouts stay where the camera looks: at the one before, else at the target.
        self._middle = (finished.design.T if has_layout else V[F][..., :2]).mean((0, 1))
        self._last: Optional[tuple[np.ndarray, np.ndarray]] = None
        self.seconds, self.restarting = 0.0, False

    def start(self, edges: np.ndarray, done: Callable[[], None]) -> None:
        """With these cuts, C x 2, and those of pieces. What runs of it already is dropped. done is called in
        the window's thread, after the run's end."""
        if LIVE.runs_on(self._design):
            self.restarting = True
            try:
                LIVE.cancel()
            finally:
                self.restarting = False
        begun, twin = time.perf_counter(), self._project.copy()
        twin.give("cut request", CutRequest(edges=np.asarray(edges, np.int32).reshape(-1, 2)))

        def work(job: Job) -> Any:
            listen = job.listen
            if listen is not None:
                tell = listen
                job.listen = lambda stage, T, *others: tell(stage, self._in_sight(T), *others)
            design = twin.run(("layout",), job)["layout"].design
            return self._in_sight(design.T), design.q

        def finish(design: Any, value: Any) -> None:
            self._last = value
            self.seconds = time.perf_counter() - begun

        LIVE.start(self._design, Task(translate("CurveUps_Cuts", "Lay out"), work, finish, told=done))

    def show(self, overlay: Any) -> None:
        """Draws the last one."""
        if self._last is not None:
            overlay.set_iterate(*self._last)

    def _in_sight(self, T: np.ndarray) -> np.ndarray:
        return T + (self._middle - T.mean((0, 1)))


class CutsPanel(Panel):
    """A click is a step of undo."""

    def __init__(self, design: Any):
        super().__init__(design, "cuts", translate("CurveUps_Cuts", "Cuts of {name}", name=design.Label))
        form = self.form
        self._paths: Optional[CutPaths] = None
        self._tip: Optional[int] = None      # vertex that the next click goes on from
        self._preview: list[Edge] = []
        self._listed: Optional[tuple] = None
        self._search: Any = None
        self._layout: Optional[CutLayout] = None
        self._lines = CutLines(self._overlay)
        self._tool: Optional[PickTool] = None
        self._on_clicks(anew=self._begin_anew, remove=self._remove, suggest=self._suggest,
                        accept=self._accept)
        form.live.toggled.connect(lambda on: self._lay_out() if on else self._stop_layout())
        form.cuts.itemSelectionChanged.connect(lambda: self._draw())
        form.suggested.itemSelectionChanged.connect(lambda: self._show_suggestion())
        form.suggested.setVisible(False)
        form.cuts.header().setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        self._show_buttons()
        self._follow()
        self._edited = QtCore.QTimer(form)
        self._edited.setSingleShot(True)
        self._edited.timeout.connect(lambda: self._look_at_cuts())
        FreeCAD.addDocumentObserver(self)
        unit_observers.append(self._look_at_cuts)
        with errors_shown(translate("CurveUps_Cuts", "Cuts")):
            self._prepare()

    def close(self) -> None:
        super().close()
        if self._look_at_cuts in unit_observers:
            FreeCAD.removeDocumentObserver(self)
            unit_observers.remove(self._look_at_cuts)
        if LIVE.runs_on(self.design):
            LIVE.cancel()
        if self._tool is not None:
            self._tool.close()
        if not self._overlay.closed:
            self._lines.close()
            self._overlay.show_design()

    def show(self) -> None:
        """The overlay has changed: lines go along."""
        if self._overlay.scene is not None:
            self._uncover()
        self._draw()

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """A property of a document object has changed, by undo too."""
        if name == "Edges" and not self._overlay.closed and obj == self.design.Cuts:
            self._edited.start(0)

    # The target whose edges are picked.

    def _prepare(self) -> None:
        """A target that is not there, or not up to date, is made first."""
        project = document.project_of(self.design)
        if project.out_of_date("target smoothing") == ():
            self._begin(project)
            return
        runs.start("divide", self.design, lambda: self._begin(document.project_of(self.design)))

    def _begin(self, project: Any) -> None:
        self._paths = CutPaths(project.latest("target smoothing").V, project.latest("target").F)
        self._layout = CutLayout(self.design, project)
        self._tool = PickTool(self.design, self._hover, self._click, self._begin_anew)
        self._look_at_cuts()

    def _edges(self) -> list[Edge]:
        return [(min(edge), max(edge)) for edge in document.cuts_of(self.design).tolist()]

    def _set(self, edges: Iterable[Edge], what: str) -> None:
        """One step of undo."""
        kept = [[int(a), int(b)] for a, b in dict.fromkeys(edges)]
        with errors_shown(what), transaction(self.design.Document, what):
            call("document.set_cuts", named(self.design), repr(kept))
        self._say("")
        self._look_at_cuts()

    # The mouse.

    def _reach(self, found: Optional[Pick]) -> tuple[list[Edge], Optional[int]]:
        if found is None or self._paths is None or found.overlay.scene is None:
            return [], self._tip
        if not np.array_equal(found.overlay.scene.F, self._paths.F):
            raise CurveUpsError(translate("CurveUps_Cuts", "the layout is of another target"),
                                self.design.Label, translate("CurveUps_Cuts", "run Solve first"))
        a, b = found.vertices
        if self._tip is None:  # the first path goes on from the nearer end
            ends = np.linalg.norm(found.ends - found.point, axis=1)
            a, b = (a, b) if ends[1] < ends[0] else (b, a)
        return self._paths.reach((a, b), self._tip)

    def _hover(self, found: Optional[Pick]) -> None:
        try:
            preview = self._reach(found)[0]
        except CurveUpsError:
            preview = []
        if found is not None and tuple(sorted(found.vertices)) in self._edges():
            preview = [(min(found.vertices), max(found.vertices))]
        if preview != self._preview:
            self._preview = preview
            self._draw()

    def _click(self, found: Pick) -> None:
        self._preview = []
        with errors_shown(translate("CurveUps_Cuts", "Cuts")):
            edges, picked = self._edges(), (min(found.vertices), max(found.vertices))
            if picked in edges:
                self._tip = None
                self._set([edge for edge in edges if edge != picked],
                          translate("CurveUps_Cuts", "Take a cut back"))
                return
            added, self._tip = self._reach(found)
            if not added:
                self._say(translate("CurveUps_Cuts", "The rim is open already: click an edge inside"))
                return
            self._set([*edges, *added], translate("CurveUps_Cuts", "Cut"))

    def _begin_anew(self) -> bool:
        """Whether there was a path to end."""
        was, self._tip, self._preview = self._tip is not None, None, []
        self._draw()
        return was

    # The lists.

    def _look_at_cuts(self) -> None:
        """Follows undo, redo and scripts."""
        if self.form is None or self._paths is None:
            return
        edges, schema = tuple(self._edges()), FreeCAD.Units.getSchema()
        if (edges, schema) != self._listed:
            before, self._listed = self._listed, (edges, schema)
            self._list(edges)
            self._draw()
            if before is not None and before[0] != edges:
                self._lay_out()

    def _list(self, edges: tuple) -> None:
        tree, paths = self.form.cuts, self._paths
        tree.clear()
        if self._tip is not None and not any(self._tip in edge for edge in edges):
            self._tip = None  # what it ended was taken back
        for number, group in enumerate(groups(edges), 1):
            millimetres = paths.length(group) if paths else 0.0
            length = FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length)
            item = QtWidgets.QTreeWidgetItem([str(number), str(len(group)), length.UserString])
            item.setData(0, QtCore.Qt.UserRole, group)
            tree.addTopLevelItem(item)
        enable(self.form.remove, "" if edges else translate("CurveUps_Cuts", "There are no cuts"))

    def _selected(self) -> list[Edge]:
        return [(a, b) for item in self.form.cuts.selectedItems()
                for a, b in item.data(0, QtCore.Qt.UserRole)]

    def _remove(self) -> None:
        chosen = self._selected() or self._edges()
        self._tip = None
        self._set([edge for edge in self._edges() if edge not in chosen],
                  translate("CurveUps_Cuts", "Remove cuts"))

    def _draw(self) -> None:
        if self._paths is None or self._overlay.closed:
            return
        self._show_buttons()
        kinds = {"hovered": self._preview, "selected": self._selected(),
                 "suggested": [edge for cut in self._chosen() for edge in cut.edges.tolist()],
                 "cut": self._edges()}
        taken: set[Edge] = set()  # an edge has one line: that of the first kind
        for kind, edges in kinds.items():
            kinds[kind] = [edge for edge in edges if (min(edge), max(edge)) not in taken]
            taken.update((min(edge), max(edge)) for edge in edges)
        self._lines.draw(kinds)

    # Suggestions.

    def _suggest(self) -> None:
        self._stop_layout()
        with errors_shown(translate("CurveUps_Cuts", "Suggest")):
            twin = document.project_of(self.design).copy()
            request = CutRequest(edges=document.cuts_of(self.design))
            twin.give("cut request", replace(request, suggested=self.form.most.value()))

            def finish(design: Any, found: Any) -> None:
                self._search = found
                self._list_suggestions()

            LIVE.start(self.design, Task(translate("CurveUps_Cuts", "Suggest"),
                                         lambda job: twin.run(("cut search",), job)["cut search"], finish))

    def _list_suggestions(self) -> None:
        tree = self.form.suggested
        tree.clear()
        cuts = self._search.cuts if self._search is not None else ()
        for cut in cuts:
            item = QtWidgets.QTreeWidgetItem([str(cut)])
            item.setToolTip(0, str(cut))
            tree.addTopLevelItem(item)
        tree.setVisible(bool(cuts))
        if self._search is not None and not cuts:
            self._say(translate("CurveUps_Cuts", "Found no cut that is worth making"))
        if cuts:
            tree.setCurrentItem(tree.topLevelItem(0))

    def _show_suggestion(self) -> None:
        """What it is predicted to gain, in full."""
        chosen = self._chosen()
        self._show_buttons()
        self.form.gain.setText(str(chosen[-1]) if chosen else "")
        self._draw()

    def _chosen(self) -> list:
        """The suggestion that is selected, and those before it, on which it rests."""
        tree = self.form.suggested
        rows = [tree.indexOfTopLevelItem(item) for item in tree.selectedItems()]
        return list(self._search.cuts[:max(rows) + 1]) if rows and self._search is not None else []

    def _accept(self) -> None:
        added = [(min(edge), max(edge)) for cut in self._chosen() for edge in cut.edges.tolist()]
        self._search = None
        self._list_suggestions()
        self._set([*self._edges(), *added], translate("CurveUps_Cuts", "Accept suggested cuts"))

    # The layout that follows.

    def _lay_out(self) -> None:
        scene = self._overlay.scene
        if (self._layout is None or not self.form.live.isChecked() or scene is None or self._paths is None
                or not np.array_equal(scene.F, self._paths.F)):
            return
        with errors_shown(translate("CurveUps_Cuts", "Lay out")):
            self._layout.start(document.cuts_of(self.design), self._laid_out)

    def _laid_out(self) -> None:
        """The layout stands: it is shown, not stored."""
        if self._overlay.closed or self._layout is None:
            return
        self._layout.show(self._overlay)
        self.form.doing.setText(translate(
            "CurveUps_Cuts", "Layout in {seconds:.1f} s. Solve repairs and verifies it.",
            seconds=self._layout.seconds))
        self._draw()

    def _stop_layout(self) -> None:
        if LIVE.runs_on(self.design):
            LIVE.cancel()

    # What is going on.

    def _say(self, text: str) -> None:
        if self._layout is not None and self._layout.restarting:
            return  # that it was cancelled for the next cut is no news
        super()._say(text)

    def _show_buttons(self) -> None:
        chosen = bool(self._chosen())
        enable(self.form.suggest, LIVE.obstacle())
        enable(self.form.accept, "" if chosen else translate(
            "CurveUps_Cuts", "Click Suggest first, then select a cut"))
        enable(self.form.anew, "" if self._tip is not None else translate(
            "CurveUps_Cuts", "The next click begins a new cut as it is"))

    def _show_run(self, status: Status, goes_on: bool) -> None:
        mine = goes_on and LIVE.runs_on(self.design)
        self._show_buttons()
        if mine:
            self.form.doing.setText(f"{status.what}, {status.seconds:.1f} s")
            self._draw()
        else:
            self.form.doing.setText("")
