# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the files of a run in their order."""

from __future__ import annotations

import json
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path
from typing import Any, Callable, Optional, Sequence

import numpy as np

from ..base.errors import Stopped
from ..base.native import native
from ..base.output import Folder
from ..project.project import Results
from ..stages.stage import Job, Picture, Row
from . import check
from .data import build_report, has_solids, to_text
from .html import Drawn, build_html, draw_pictures

REPORTS = ("report.json", "report.html")


# Writes the parametric document of results to a path; returns versions of software.
WriteDocument = Callable[[Results, Path], dict[str, str]]


def write_files(results: Results, path: Path, job: Job, write_document: WriteDocument) -> bool:
    """Write all files of a run. Return whether the run was stopped.

    The reports of an earlier run go first, its files under this name next, and report.json comes last, so
    that the folder never claims what it doesn't hold. A stop between files leaves the complete ones and the
    reports, which list them.
    """
    start = time.perf_counter()
    rows, stopped, software = results.rows(), results.stopped, dict[str, str]()
    with Folder(path) as folder:
        folder.remove(*REPORTS, *_earlier(results, path))
        folder.write_text("design.json", native.write_design(results.design))
        suggested = results.get("suggestions")
        if suggested is not None and suggested.proposed:
            edges = np.vstack([results.design.cuts, *(cut.edges for cut in suggested.proposed)])
            folder.write_text(f"{results.name}-cuts.json",  # as `--cuts` takes them
                              json.dumps({"edges": np.sort(edges, axis=1).tolist()}) + "\n")
        drawn: Optional[Sequence[tuple[Picture, Drawn]]] = None
        if has_solids(results):
            try:
                # FreeCAD and matplotlib work on this thread, beside the native module.
                with ThreadPoolExecutor(1) as beside:
                    bodies = beside.submit(_write_all_bodies, results, folder, job)
                    document = f"{results.name}.FCStd"
                    job.go_on(f"writing {document}")
                    folder.write(document, lambda place: software.update(write_document(results, place)))
                    with suppress(ModuleNotFoundError):  # the page says so
                        drawn = draw_pictures(results)
                    bodies.result()
            except (Stopped, native.Cancelled):
                stopped = True
            rows.append(Row("export", time.perf_counter() - start))
        write_reports(results, folder, rows, stopped, software, drawn)
    return stopped


def _write_all_bodies(results: Results, folder: Folder, job: Job) -> None:
    """Write first what is sent to the printer. A kind without bodies (anchors off) has no file."""
    bodies = results["bodies"]
    for form in sorted(native.print_formats(), key=lambda form: form.ending != "3mf"):
        for kind in form.kinds:
            if kind in (*bodies.kinds, "print", "actuated"):
                write_bodies(folder, f"{results.name}-{kind}.{form.ending}", bodies.model, kind, job)


def write_bodies(folder: Folder, name: str, model: Any, kind: str, job: Job,
                 title: Optional[str] = None) -> None:
    """Write bodies of a kind of a native PrintModel in the format of the name's ending. title: stands inside
    of the file; by default the model's name."""
    job.go_on(f"writing {name}")
    folder.write(name, lambda place: model.write(name.rpartition(".")[2], kind, str(place), job, title))


def write_verification(results: Results, design: Any, path: Path) -> None:
    """The reports on a design as it was given, beside it. Print files in the folder stay where they are
    of this design, and go with the reports where they are of another."""
    with Folder(path) as folder:
        folder.remove(*REPORTS)
        keep_design(folder, results, native.write_design(design))
        write_reports(results, folder)


def keep_design(folder: Folder, results: Results, text: str) -> None:
    """Writes design.json where the folder holds another or none; what was made of that goes first."""
    path = folder.path / "design.json"
    if not path.is_file() or path.read_bytes() != text.encode("utf-8"):
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
    names = [f"{name}-{kind}.{form.ending}" for form in native.print_formats() for kind in form.kinds]
    request = results.get("cut request")
    given = Path(request.where) if request is not None and request.where else None
    cuts = path / f"{name}-cuts.json"
    if not (given and cuts.exists() and given.exists() and cuts.samefile(given)):
        names.append(cuts.name)
    return [*names, f"{name}.FCStd"]


def write_reports(results: Results, folder: Folder, rows: list[Row] | None = None, stopped: bool = False,
                  software: dict[str, str] | None = None,
                  drawn: Optional[Sequence[tuple[Picture, Drawn]]] = None) -> None:
    """Write report.html, then report.json, which lists all other files. rows: with those of writing."""
    report = build_report(results, results.rows() if rows is None else rows, stopped or results.stopped,
                          folder.files, software or {})
    try:
        folder.write("report.html", lambda path: path.write_text(build_html(results, report, drawn), "utf-8"))
    finally:  # the page needs packages that a FreeCAD may lack
        if "print" in report:
            report["print"]["files"] = dict(sorted(folder.files.items()))
        folder.write_text("report.json", to_text(report))


def write_obj(folder: Folder, name: str, V: np.ndarray, F: np.ndarray) -> None:
    """A mesh whose numbers read back to the same doubles."""
    lines = [f"v {float(x)!r} {float(y)!r} {float(z)!r}" for x, y, z in V]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in F]
    folder.write_text(name, "\n".join(lines) + "\n")
