# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a run, in the order in which they are written."""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Any, Callable

import numpy as np

from .errors import Stopped
from .native import native
from .output import Folder
from .project import Results
from .report.data import build_report, to_text
from .report.html import build_html
from .stages.solids import Solids
from .stages.stage import Job, Row


def write_results(results: Results, path: Path, job: Job) -> tuple[Folder, bool]:
    """design.json, the solids' files and the document, then the reports. A stop between files leaves
    those already complete and the reports, which say so. Returns the folder and whether all was
    written or, at any time, the run was stopped."""
    folder = Folder(path)
    start = time.perf_counter()
    folder.write_text("design.json", native.write_design(results.design))
    suggested = results.get("suggestions")
    if suggested is not None and suggested.proposed:
        folder.write_text(f"{results.name}-cuts.json", cuts_text(results))
    software: dict[str, str] = {}
    rows, stopped = results.rows(), results.stopped
    solids = results.get("solids")
    if solids is not None and solids.model is not None:
        try:
            _write_solids(solids, results.name, folder, job)
            _write_document(results, folder, job, software)
        except (Stopped, native.Cancelled):
            stopped = True
        rows.append(Row("export", time.perf_counter() - start))
    write_reports(results, folder, rows, stopped, software)
    return folder, stopped


def _write_solids(solids: Solids, name: str, folder: Folder, job: Job) -> None:
    """A kind of which there are no bodies (anchors switched off) has no file."""
    model: Any = solids.model
    for ending, kinds in native.print_formats():
        for kind in kinds:
            if kind in (*solids.kinds, "print", "actuated"):
                _write(folder, f"{name}-{kind}.{ending}", job,
                       lambda path: model.write(ending, kind, path, job))


def _write_document(results: Results, folder: Folder, job: Job, software: dict[str, str]) -> None:
    from . import freecad_io

    def write(path: str) -> None:
        software.update(freecad_io.write_document(results, Path(path)))

    _write(folder, f"{results.name}.FCStd", job, write)


def _write(folder: Folder, name: str, job: Job, writer: Callable[[str], None]) -> None:
    if not job(f"writing {name}"):
        raise Stopped
    folder.write(name, lambda path: writer(str(path)))


def write_reports(results: Results, folder: Folder, rows: list[Row] | None = None,
                  stopped: bool = False, software: dict[str, str] | None = None) -> None:
    """report.html, then report.json, which lists all files but itself. rows: with those of writing."""
    report: dict[str, Any] = {}
    shown = results.rows() if rows is None else rows
    stopped = stopped or results.stopped

    def write_page(path: Path) -> None:
        report.update(build_report(results, shown, stopped, folder.files, software or {}))
        path.write_bytes(build_html(results, report).encode("utf-8"))

    folder.write("report.html", write_page)
    if "print" in report:
        report["print"]["files"] = dict(folder.files)
    folder.write_text("report.json", to_text(report))


def cuts_text(results: Results) -> str:
    """The design's cuts and those proposed, as `--cuts` takes them."""
    edges = np.vstack([results.design.cuts, *(cut.edges for cut in results["suggestions"].proposed)])
    return json.dumps({"edges": np.sort(edges, axis=1).tolist()}) + "\n"


def write_obj(folder: Folder, name: str, V: np.ndarray, F: np.ndarray) -> None:
    """A mesh whose numbers read back to the same doubles."""
    lines = [f"v {float(x)!r} {float(y)!r} {float(z)!r}" for x, y, z in V]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in F]
    folder.write_text(name, "\n".join(lines) + "\n")
