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
from .pipeline import Stage
from .progress import Progress
from .report.data import build_report, to_text
from .report.html import build_html


def write_outcome(outcome: Any, path: Path, progress: Progress) -> Folder:
    """design.json, the solids' files and the document, then the reports. A stop between files
    leaves those already complete and the reports, which say so."""
    folder = Folder(path)
    start = time.perf_counter()
    folder.write_text("design.json", native.write_design(outcome.design))
    if outcome.suggestions.proposed:
        folder.write_text(f"{outcome.name}-cuts.json", cuts_text(outcome))
    software: dict[str, str] = {}
    if outcome.model is not None:
        try:
            _write_solids(outcome, folder, progress)
            _write_document(outcome, folder, progress, software)
        except (Stopped, native.Cancelled):
            outcome.stopped = True
        outcome.stages.append(Stage("export", time.perf_counter() - start))
    write_reports(outcome, folder, software)
    return folder


def _write_solids(outcome: Any, folder: Folder, progress: Progress) -> None:
    """STEP, STL and 3MF; a kind of which there are no bodies (anchors switched off) has no file."""
    model, name = outcome.model, outcome.name
    there = [kind for kind in ("tiles", "support", "anchors") if model.volumes[kind] > 0]
    for kind in (*there, "print", "actuated"):
        _write(folder, f"{name}-{kind}.step", progress,
               lambda path: model.write_step(kind, path, progress))
    for kind in there:
        _write(folder, f"{name}-{kind}.stl", progress,
               lambda path: model.write_stl(kind, path, progress))
    _write(folder, f"{name}-print.3mf", progress, lambda path: model.write_3mf(path, progress))


def _write_document(outcome: Any, folder: Folder, progress: Progress,
                    software: dict[str, str]) -> None:
    from . import freecad_io

    def write(path: str) -> None:
        software.update(freecad_io.write_document(outcome, Path(path)))

    _write(folder, f"{outcome.name}.FCStd", progress, write)


def _write(folder: Folder, name: str, progress: Progress, writer: Callable[[str], None]) -> None:
    if not progress(f"writing {name}", -1.0):
        raise Stopped
    folder.write(name, lambda path: writer(str(path)))


def write_reports(outcome: Any, folder: Folder, software: dict[str, str] | None = None) -> None:
    """report.html, then report.json, which lists all files but itself."""
    report: dict[str, Any] = {}

    def write_page(path: Path) -> None:
        report.update(build_report(outcome, folder.files, software or {}))
        path.write_bytes(build_html(outcome, report).encode("utf-8"))

    folder.write("report.html", write_page)
    if "print" in report:
        report["print"]["files"] = dict(folder.files)
    folder.write_text("report.json", to_text(report))


def cuts_text(outcome: Any) -> str:
    """The design's cuts and those proposed, as `--cuts` takes them."""
    edges = np.vstack([outcome.design.cuts, *(cut.edges for cut in outcome.suggestions.proposed)])
    return json.dumps({"edges": np.sort(edges, axis=1).tolist()}) + "\n"


def write_obj(folder: Folder, name: str, V: np.ndarray, F: np.ndarray) -> None:
    """A mesh whose numbers read back to the same doubles."""
    lines = [f"v {float(x)!r} {float(y)!r} {float(z)!r}" for x, y, z in V]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in F]
    folder.write_text(name, "\n".join(lines) + "\n")
