# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a kit: what the print shop gets, the sheets for whoever builds the shell, and kit.json."""

from __future__ import annotations

import glob
import hashlib
import json
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any, Callable, Sequence, TypeVar

from ..base.errors import CurveUpsError, Stopped
from ..base.language import Language
from ..base.native import native
from ..base.output import Folder
from ..project.project import Project, Results
from ..report.assembly import GLUE_LAYER, glue_asked, glue_volumes, steps
from ..report.data import build_report, to_text
from ..report.exports import Choice, File, file_names
from ..report.files import keep_design
from ..report.shop import has_bridges, latex, quote, rules
from ..stages import stages_of
from ..stages.solids import amounts
from ..stages.stage import Job
from .beds import bed_name
from .former import figures
from .kit import Kit

_T = TypeVar("_T")
FORMAT, VERSION = "curveups-kit", 1
KIT = "kit.json"
_ENDINGS = (".3mf", ".step", ".stl", ".pdf", ".svg", ".dxf")


@dataclass(frozen=True)
class Order:
    """Choices of the user. mask: names of print files (exports.py); language: of sheets."""

    quantity: int = 1
    mask: str = "{name}-{body}"
    language: str = "en"

    @property
    def data(self) -> dict[str, Any]:
        """Entries of kit.json."""
        return {"quantity": self.quantity, "names": self.mask, "language": self.language}


def goals() -> tuple[str, ...]:
    """The stages whose results a kit is made from."""
    return ("figures", *stages_of("verify"), *stages_of("print"), "anchoring")


def make(project: Project, job: Job) -> Results:
    """Results that a kit is made from."""
    return project.run(goals(), job, strict=True)


def print_names(name: str, parameters: Any, kinds: Sequence[str], order: Order) -> dict[File, str]:
    """Names of print files. kinds: of bodies. Raises CurveUpsError for a mask that does not do."""
    return _named(name, parameters, order, tuple(
        (kind, form.ending) for form in native.print_formats() for kind in form.wanted
        if kind in (*kinds, "print")))


def _named(name: str, parameters: Any, order: Order, wanted: tuple[File, ...]) -> dict[File, str]:
    soluble = native.support_kind(parameters).soluble
    height = 2 * parameters.get("H_pin") + parameters.get("H_body")
    return file_names(name, Choice(wanted, order.mask), {
        "material": lambda kind: "soluble" if kind == "support" and soluble else "rigid",
        "thickness": lambda kind: f"{height:g}mm", "quantity": lambda kind: f"{order.quantity}x"})


def write_kit(results: Results, path: Path, job: Job, order: Order = Order()) -> bool:
    """Writes all files of a kit; True if that was stopped. kit.json is removed first and written last: what
    it does not list, this run did not write."""
    design = native.write_design(results.design)
    names = print_names(results.name, results.parameters, results["bodies"].kinds, order)
    report = build_report(results, results.rows(), False, {}, {})

    def named(file: File) -> str:
        return _named(results.name, results.parameters, order, (file,))[file]

    kit = Kit(results, report, order.quantity, names, named, say=Language(order.language))
    stopped = results.stopped
    with Folder(path) as folder:
        folder.remove(KIT, *_earlier(path, kit.name))
        keep_design(folder, results, design)
        try:
            if (borders := kit.borders)["pairs"]:
                report["borders"] = borders
            kit.go_on = partial(job.go_on, "dividing the print among beds")
            kit.go_on()
            kit.divide()
            if kit.beds:
                report["beds"] = kit.beds.figures(kit.printer)
                report["print"] = {**report["print"], **amounts(kit.prints)}
            writers = {**_print_files(kit), **import_module(".sheets", __package__).files(kit)}
            for number, (name, writer) in enumerate(writers.items()):
                kit.go_on = partial(job.go_on, f"writing {name}", number / len(writers))
                kit.go_on()
                folder.write(name, lambda place: place.write_bytes(writer()))
                data = (path / name).read_bytes()
                kit.files[name] = {"bytes": len(data), "sha256": _sum(data)}
        except (Stopped, native.Cancelled):
            stopped = True
        folder.write_text(KIT, to_text(_contents(kit, design, stopped, order)))
    return stopped


def _print_files(kit: Kit) -> dict[str, Callable[[], bytes]]:
    """Makers of the files that the shop prints, by name: the whole, each bed if there are several, and the
    print on bridges as closed shells."""
    writers: dict[str, Callable[[], bytes]] = {
        name: partial(kit.written, kit.model, ending, kind)
        for (kind, ending), name in kit.names.items()}
    fused = ("stl", "3mf") if has_bridges(kit.results.parameters) else ()
    for number, model in enumerate(kit.prints):
        bed = bed_name(number) if kit.beds else "print"
        if kit.beds:
            writers.update({kit.named((bed, ending)): partial(kit.written, model, ending, "print")
                            for ending in ("3mf", "step")})
        writers.update({kit.named((f"{bed}-fused", ending)): partial(kit.written, model, ending, "fused")
                        for ending in fused})
    return writers


def _earlier(folder: Path, name: str) -> list[str]:
    """Files of the last kit in a folder that nobody has changed since, and those of beds and frame that a run
    without an end has left."""
    listed = _last(folder, lambda contents: {file: str(about["sha256"])
                                             for file, about in contents["files"].items()}, dict[str, str]())
    unchanged = [file for file, known in listed.items()
                 if Path(file).name == file and (folder / file).is_file()
                 and _sum((folder / file).read_bytes()) == known]
    beds = [place.name for pattern in ("bed-[0-9][0-9]*.*", "frame.*")
            for place in folder.glob(f"{glob.escape(name)}-{pattern}")
            if place.name not in listed and place.suffix in _ENDINGS]
    return [*unchanged, *beds]


def _last(folder: Path, take: Callable[[Any], _T], otherwise: _T) -> _T:
    """Value that `take` reads from the last kit.json in a folder; `otherwise` where there is none or it is
    damaged."""
    try:
        return take(json.loads((folder / KIT).read_text("utf-8")))
    except (CurveUpsError, OSError, ValueError, LookupError, TypeError, AttributeError):
        return otherwise


def _contents(kit: Kit, design: str, stopped: bool, order: Order) -> dict[str, Any]:
    """kit.json."""
    report, parameters = kit.report, kit.results.parameters
    printed = {name: value for name, value in report["print"].items() if name != "files"}
    blocks = ("beds", "area", "solids", "sheets", "anchors", "contact_forces", "worst_contacts",
              "joints", "borders")
    return {"format": FORMAT, "version": VERSION, "name": kit.name, "title": kit.results.title,
            "status": "stopped" if stopped else "complete", "design_sha256": _sum(design.encode("utf-8")),
            "valid": report["valid"], "holds": report["holds"], "reasons": report["reasons"],
            **order.data, "tiles": report["tiles"], "contacts": report["contacts"],
            "cuts": report["cuts"], "print": printed,
            **{name: report[name] for name in blocks if name in report},
            "rings": kit.rings, "former": figures(kit.formers),
            "glue": {"layer_mm": GLUE_LAYER, "volume_cm3": glue_volumes(printed["glue"]),
                     "asked_mpa": glue_asked(report)},
            "shop": {"rules": rules(report, parameters),
                     "quote": {**dict(quote(report, parameters, kit.quantity, whole=kit.whole)),
                               "Membranes": latex(report, parameters)}},
            "steps": [{"title": step.title, "text": step.text} for step in steps(report, parameters)],
            "files": kit.files}


def _sum(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def last_order(folder: Path) -> Order:
    """The order of the kit in a folder; the usual one where there is none."""
    return _last(folder, lambda contents: Order(int(contents["quantity"]), str(contents["names"]),
                                                Language(contents["language"]).name), Order())
