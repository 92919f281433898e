# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes chosen files of a design, under names that the user chooses; a design that should not be printed
says so in every file whose format has a place for that, and in the reports."""

from __future__ import annotations

import string
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import Callable, Iterable, Mapping, Optional

from ..base.errors import CurveUpsError, Stopped, named_tiles
from ..base.findings import Finding
from ..base.native import native, translated
from ..base.output import Folder, safe_name
from ..project.project import Made, Project, Results
from ..stages import stages_of
from ..stages.stage import Block, Job
from .files import REPORTS, write_bodies, write_reports

File = tuple[str, str]  # kind of bodies, ending: of native.print_formats()


@dataclass(frozen=True)
class Choice:
    """mask: names of files, with {name} and {body}. deviation: of triangulated bumps, mm. doubts: why the
    design should not be printed; `insist` writes it all the same."""

    files: tuple[File, ...]
    mask: str = "{name}-{body}"
    deviation: Optional[float] = None
    reports: bool = True
    doubts: tuple[Finding, ...] = ()
    insist: bool = False


def choices() -> list[File]:
    """All files that there are."""
    return [(kind, form.ending) for form in native.print_formats() for kind in form.kinds]


def file_names(name: str, choice: Choice, more: Mapping[str, Callable[[str], str]] = MappingProxyType({})
               ) -> dict[File, str]:
    """The name of each chosen file. more: other fields that the mask may have, by the kind of bodies. Raises
    CurveUpsError for a mask that does not do."""
    fields: dict[str, Callable[[str], str]] = {"name": lambda kind: safe_name(name), "body": str, **more}
    *most, last = (f"{{{field}}}" for field in fields)
    known = f"{', '.join(most)} and {last}"
    try:
        used = {part[1] for part in string.Formatter().parse(choice.mask) if part[1] is not None}
    except ValueError as error:
        raise CurveUpsError(f"the names '{choice.mask}' can't be read: {error}", "", f"use {known}") from None
    if used - set(fields):
        raise CurveUpsError(f"the names '{choice.mask}' ask for {{{sorted(used - set(fields))[0]}}}", "",
                            f"use {known}")
    names: dict[File, str] = {}
    for kind, ending in choice.files:
        stem = choice.mask
        for field, value in fields.items():
            stem = stem.replace(f"{{{field}}}", value(kind))
        file = f"{safe_name(stem)}.{ending}"
        if stem != safe_name(stem):
            raise CurveUpsError(f"'{stem}' is no name for a file", "",
                                f"use letters, digits, '-', '_', {known}")
        if file in names.values():
            raise CurveUpsError(f"two files would be called {file}", "", "put {body} into the names")
        names[kind, ending] = file
    return names


def all_names(name: str, choice: Choice) -> list[str]:
    """Names of all that write_export writes. Raises CurveUpsError as file_names does."""
    return [*file_names(name, choice).values(), "design.json", *(REPORTS if choice.reports else ())]


def write_export(project: Project, folder: Path, choice: Choice, job: Job) -> Folder:
    """Write the chosen files and the reports; reports of earlier files go first. Raises CurveUpsError where
    the design is doubtful and not insisted on or a file can't be written, Stopped where it was stopped:
    complete files stay then, without a report."""
    if choice.doubts and not choice.insist:
        raise _doubtful(choice.doubts[0], project)
    if not choice.files:
        raise CurveUpsError("no file is chosen", project.where, "choose a body and a format")
    names = file_names(project.name, choice)
    results = _printed(project, choice.deviation, job)
    broken = [reason for stage in stages_of("print") for reason in results[stage].reasons()]
    if broken and not choice.insist:
        raise _doubtful(broken[0], project)
    with Folder(folder) as place, translated(project.where):
        place.remove(*REPORTS)
        place.write_text("design.json", native.write_design(results.design))
        bodies, title = results["bodies"], doubtful(results.title, False) if choice.doubts else None
        for (kind, ending), file in names.items():
            if kind in (*bodies.kinds, "print", "actuated"):
                write_bodies(place, file, bodies.model, kind, job, title)
        if choice.reports:
            write_reports(_with(results, choice.doubts), place)
    return place


def write_spares(project: Project, folder: Path, tiles: str, job: Job) -> list[str]:
    """Writes these tiles alone, "T00012,T00345", at their places in the print; the files' names."""
    rows = sorted(set(named_tiles(tiles, len(project.latest("design").design.F), "--tiles")))
    model = project.run(("bodies",), job, strict=True)["bodies"].model
    if model is None:
        raise Stopped
    spares = model.only_tiles(rows)
    with Folder(folder) as place, translated(project.where):
        for form in native.print_formats():
            kind, file = "tiles" if "tiles" in form.kinds else "print", f"{project.name}-spares.{form.ending}"
            write_bodies(place, file, spares, kind, job)
    return list(place.files)


def report(project: Project, folder: Path, doubts: Iterable[Finding], job: Job) -> Path:
    """Writes report.html and report.json of all that is current; the page."""
    current = _current(project, stages_of("solve", "settle", "actuate"))
    results = project.run(current, job, note=Finding("unverified"))
    place = Folder(folder)
    write_reports(_with(results, tuple(doubts)), place)
    return place.path / "report.html"


def doubtful(title: str, valid: Optional[bool]) -> str:
    """The title that files carry inside: of a design that should not be printed it says so first."""
    return {True: "", False: "NOT VALID ", None: "NOT VERIFIED "}[valid] + title


def _doubtful(why: Finding, project: Project) -> CurveUpsError:
    return CurveUpsError(str(why), project.where, "mend that, or insist on the files", finding=why)


def _printed(project: Project, deviation: Optional[float], job: Job) -> Results:
    """Bodies whose bumps have this deviation; verification as far as it is current."""
    goals = (*_current(project, stages_of("verify")), *stages_of("print"))
    printed, parameters = project.copy(), project.parameters
    if deviation is not None:
        with translated("mesh_deviation"):
            parameters.set("mesh_deviation", deviation)
        printed.parameters = parameters
    results = printed.run(goals, job, True, Finding("unverified.export"))
    if job.stopped:
        raise Stopped
    return results


def _current(project: Project, names: Iterable[str]) -> tuple[str, ...]:
    """Names of the stages whose results are current; figures take no time."""
    return ("figures", *(name for name in names if project.out_of_date(name) == ()))


def _with(results: Results, doubts: tuple[Finding, ...]) -> Results:
    """Results whose verdict has these reasons, too: why files that are insisted on should not be printed."""
    return replace(results, made={**results.made, "doubt": Made(Block("doubt", broken=doubts))})
