# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the files of a run in their order."""

from __future__ import annotations

import json
import shutil
import threading
import time
from contextlib import ExitStack, nullcontext, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, ContextManager, Optional

import numpy as np

from ..base import freecad_session
from ..base.errors import CurveUpsError, Stopped
from ..base.machine import memory_is_limited
from ..base.native import native
from ..base.output import Folder, Prepared
from ..project.project import Results
from ..stages import solids as solids_stage
from ..stages.solids import Solids
from ..stages.stage import Job, Row
from . import check
from .data import build_report, has_solids, list_files, to_text
from .html import Drawn, build_html, draw

REPORTS = ("report.json", "report.html")


# Writes the parametric document of results to a path; returns versions of software.
WriteDocument = Callable[[Results, Path], dict[str, str]]


@dataclass(frozen=True)
class _Ahead:
    """The document and the page of results that are expected, which `document` waits for without its name."""

    results: Results
    document: Prepared
    page: bytes
    software: dict[str, str]

    def holds(self, results: Results) -> bool:
        """Whether the results are those expected."""
        return not results.stopped and results.keys() == self.results.keys() and all(
            result is self.results[name] or result == self.results[name] for name, result in results.items())


class Writing:
    """The files of a run: those of the design and its bodies, from the moment that they are known, on a
    thread of its own while the run goes on and checks the solids. The document and the page follow there,
    for the case that the checks find no fault: where they do, both are made anew at the end.

    A stop between files leaves those already complete and the reports, which say so. The folder never claims
    what it doesn't hold: the reports of an earlier run go first, its files under this name next, what waits
    for the checks has no name yet, and report.json comes last. A run that breaks off (`with`) takes back what
    was written. `shield`: keeps signals from cutting off what is being written.
    """

    def __init__(self, path: Path, job: Job, write_document: WriteDocument,
                 shield: Callable[[], ContextManager] = nullcontext):
        self._path, self._job, self._write_document, self._shield = path, job, write_document, shield
        self._thread: Optional[threading.Thread] = None
        self._began = ExitStack()
        self._error: Optional[BaseException] = None
        self._stopped = self._ended = False
        self._expected: Optional[Results] = None
        self._drawn: Optional[list[Drawn]] = None
        self._told = threading.Event()  # what to expect, or that there is nothing
        self._ahead: Optional[_Ahead] = None

    def __enter__(self) -> "Writing":
        return self

    def __exit__(self, kind: Any, error: Optional[BaseException], trace: Any) -> None:
        with self._began:
            if error is not None and self._thread is not None and not self._ended:
                self._job.stopped = True
                self._told.set()
                self._thread.join()
                self._drop_ahead()
                self._folder.withdraw()

    def watch(self, goal: str, results: Results) -> None:
        """For `Project.run`: begins as soon as there are solids."""
        if goal == solids_stage.STAGE.name and not self._job.stopped:
            self._begin(results)

    def expect(self, results: Results) -> None:
        """For `Project.run`: what there will be unless the checks find a fault. On the main thread, where
        FreeCAD has to be imported. Draws the page's pictures: writing would end later than the checks."""
        try:
            # Beside checks that take memory, FreeCAD might find too little after it has looked.
            if self._thread is not None and has_solids(results) and not memory_is_limited():
                with suppress(CurveUpsError, MemoryError):  # whoever writes the document says so
                    freecad_session.load("Part", "Mesh")
                self._drawn = self._draw(results)
                self._expected = results
        finally:
            self._told.set()

    def _draw(self, results: Results) -> Optional[list[Drawn]]:
        drawn = []
        try:
            for one in draw(results):
                drawn.append(one)
                self._job.go_on("drawing pictures")
        except Stopped:
            raise
        except Exception:  # whoever makes the page says so
            return None
        return drawn

    def end(self, results: Results) -> bool:
        """What is left to write. Returns whether the run was stopped at any time."""
        start = time.perf_counter()
        self._ended = True
        self._told.set()
        if self._thread is None:
            self._begin(results)
        assert self._thread is not None
        while self._thread.is_alive():
            self._thread.join(0.05)
            self._job(self._doing)
        if self._ahead is not None and not self._ahead.holds(results):
            self._drop_ahead()
        if self._error is not None:
            raise self._error
        rows, stopped = results.rows(), results.stopped or self._stopped
        software: dict[str, str] = {}
        with self._folder as folder:
            if has_solids(results):
                if self._ahead is not None:
                    folder.keep(self._ahead.document)
                    software = self._ahead.software
                elif not self._stopped:
                    try:
                        document, software = self._prepare_document(results, folder)
                        folder.keep(document)
                    except (Stopped, native.Cancelled):
                        stopped = True
                rows.append(Row("export", time.perf_counter() - start))
            write_reports(results, folder, rows, stopped, software, self._ahead.page if self._ahead else None)
        return stopped

    def _drop_ahead(self) -> None:
        if self._ahead is not None:
            self._folder.drop(self._ahead.document)
            self._ahead = None

    def _begin(self, results: Results) -> None:
        self._began.enter_context(self._shield())
        self._folder = Folder(self._path)
        self._doing = "writing design.json"
        thread = threading.Thread(target=self._write_first, args=(results,), daemon=True)
        thread.start()  # may fail, for want of memory
        self._thread = thread

    def _write_first(self, results: Results) -> None:
        try:
            with self._folder as folder:
                folder.remove(*REPORTS, *_earlier(results, self._path))
                folder.write_text("design.json", native.write_design(results.design))
                suggested = results.get("suggestions")
                if suggested is not None and suggested.proposed:
                    folder.write_text(_cuts_name(results.name), cuts_text(results))
                if has_solids(results):
                    try:
                        self._write_solids(results["solids"], results.name)
                    except (Stopped, native.Cancelled):
                        self._stopped = True
                self._told.wait()
                if self._expected is not None and not self._stopped:
                    with suppress(Stopped, native.Cancelled):
                        self._ahead = self._write_ahead(self._expected, folder)
        except BaseException as error:
            self._error, self._job.stopped = error, True  # nobody needs the checks of what can't be written

    def _write_solids(self, solids: Solids, name: str) -> None:
        """A kind of which there are no bodies (anchors switched off) has no file. What is sent to the printer
        comes first."""
        model: Any = solids.model
        for one in sorted(native.print_formats(), key=lambda found: found.ending != "3mf"):
            for kind in one.kinds:
                if kind in (*solids.kinds, "print", "actuated"):
                    file = _print_name(name, kind, one.ending)
                    self._doing = f"writing {file}"
                    self._job.go_on(self._doing)
                    # Asks for nothing but a stop: what is shown meanwhile is the checks' progress.
                    self._folder.write(file, lambda path: model.write(one.ending, kind, str(path),
                                                                      lambda *_: not self._job.stopped))

    def _prepare_document(self, results: Results, folder: Folder) -> tuple[Prepared, dict[str, str]]:
        """The document under its temporary name, and versions of software."""
        name, software = _document_name(results.name), dict[str, str]()
        self._job.go_on(f"writing {name}")
        document = folder.prepare(name, lambda path: software.update(self._write_document(results, path)))
        return document, software

    def _write_ahead(self, results: Results, folder: Folder) -> _Ahead:
        self._doing = f"writing {_document_name(results.name)}"
        document, software = self._prepare_document(results, folder)
        try:
            files = {**folder.files, document.name: document.size}
            page = _page(results, build_report(results, (), False, files, software), self._drawn)
            return _Ahead(results, document, page, software)
        except BaseException:
            folder.drop(document)
            raise


def write_verification(results: Results, design: Any, path: Path) -> None:
    """The reports on a design as it was given, beside it. Print files in the folder stay where they are
    of this design, and go with the reports where they are of another."""
    with Folder(path) as folder:
        folder.remove(*REPORTS)
        keep_design(folder, results, native.write_design(design))
        write_reports(results, folder)


def keep_design(folder: Folder, results: Results, text: str) -> None:
    """Writes design.json where the folder holds another or none; what was made of that goes first."""
    if not folder.holds("design.json", text):
        folder.remove(*REPORTS, *_earlier(results, folder.path))
        folder.write_text("design.json", text)


def write_check(results: Results, path: Path) -> None:
    """check.html, then check.json."""
    with Folder(path) as folder:
        folder.remove("check.json", "check.html")
        folder.write_text("check.html", check.build_page(results))
        folder.write_text("check.json", to_text(check.build_check(results)))


def _earlier(results: Results, path: Path) -> list[str]:
    """The files that a run under this name may have left, but for the cuts that this one was given."""
    name = results.name
    made = [_print_name(name, kind, one.ending) for one in native.print_formats() for kind in one.kinds]
    request = results.get("cut request")
    given = Path(request.where) if request is not None and request.where else None
    cuts = path / _cuts_name(name)
    if not (given and cuts.exists() and given.exists() and cuts.samefile(given)):
        made.append(cuts.name)
    return [*made, _document_name(name)]


def _print_name(name: str, kind: str, ending: str) -> str:
    return f"{name}-{kind}.{ending}"


def _document_name(name: str) -> str:
    return f"{name}.FCStd"


def _cuts_name(name: str) -> str:
    return f"{name}-cuts.json"


def write_reports(results: Results, folder: Folder, rows: list[Row] | None = None, stopped: bool = False,
                  software: dict[str, str] | None = None, page: bytes | None = None, stem: str = "") -> None:
    """report.html, then report.json, which lists all files but reports in JSON. rows: with those of writing.
    page: report.html, where it is there already. stem: of names of the same reports that a later run on
    another design leaves alone."""
    report: dict[str, Any] = {}
    shown = results.rows() if rows is None else rows
    stopped = stopped or results.stopped

    def write_page(path: Path) -> None:
        report.update(build_report(results, shown, stopped, folder.files, software or {}))
        path.write_bytes(_page(results, report) if page is None else page)

    folder.write("report.html", write_page)
    if stem:
        folder.write(f"{stem}-report.html", lambda path: shutil.copyfile(folder.path / "report.html", path))
    list_files(report, results, folder.files)
    for name in (*([f"{stem}-report.json"] if stem else []), "report.json"):
        folder.write_text(name, to_text(report))


def _page(results: Results, report: dict[str, Any], drawn: list[Drawn] | None = None) -> bytes:
    return build_html(results, report, drawn).encode("utf-8")


def cuts_text(results: Results) -> str:
    """The design's cuts and those proposed, as `--cuts` takes them."""
    edges = np.vstack([results.design.cuts, *(cut.edges for cut in results["suggestions"].proposed)])
    return json.dumps({"edges": np.sort(edges, axis=1).tolist()}) + "\n"


def write_obj(folder: Folder, name: str, V: np.ndarray, F: np.ndarray) -> None:
    """A mesh whose numbers read back to the same doubles."""
    lines = [f"v {float(x)!r} {float(y)!r} {float(z)!r}" for x, y, z in V]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in F]
    folder.write_text(name, "\n".join(lines) + "\n")
