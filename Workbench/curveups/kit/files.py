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
from types import MappingProxyType
from typing import Any, Callable, Iterator, Mapping, Sequence

from ..base.errors import CurveUpsError, Stopped
from ..base.language import Language
from ..base.native import native
from ..base.output import Folder
from ..project.project import Project, Results
from ..report.assembly import GLUE_LAYER, glue_asked, glue_volumes, steps
from ..report.data import build_report, to_text
from ..report.exports import Choice, File, doubtful, file_names, plain, run_under
from ..report.files import keep_design
from ..report.shop import has_bridges, latex, quote, rules
from ..stages import RISEN, asked_by
from ..stages.solids import amounts, read_printer
from ..stages.stage import Job
from .costs import costs
from .kit import Kit
from .prices import chosen_prices
from .underside import figures

FORMAT, VERSION = "curveups-kit", 1
KIT = "kit.json"
COUPONS = "coupons"  # the folder of theirs
MEASURED = "MEASURED.json"

_OF_BEDS = ("bed-[0-9][0-9].*", "bed-[0-9][0-9]-prusa.3mf", "bed-[0-9][0-9]-fused.*", "frame.dxf",
            "frame.pdf")
_OF_COUPONS = (".step", ".3mf", ".stl", ".pdf", ".svg", ".dxf")
_OF_ONE_BED: tuple[File, ...] = (("prusa", "3mf"), ("print-fused", "stl"), ("print-fused", "3mf"))

# What follows NAME- in files, with the module, its function and what that is given. matplotlib is loaded
# with the first of them.
_SHEETS: Mapping[str, tuple[str, ...]] = {
    "shop.pdf": ("shop_sheet", "make"),  # lists what comes before it
    **{f"latex-{side}.{kind}": ("latex", "make", side, kind)
       for side in ("front", "back") for kind in ("pdf", "svg", "dxf")},
    **{f"ring-{side}.{kind}": ("ring_sheet", "make", side, kind)
       for side in ("front", "back") for kind in ("step", "stl", "dxf")},
    **{f"assembly.{kind}": ("assembly_sheet", "make", kind) for kind in ("html", "pdf")},
    "tiles.svg": ("tile_map", "make"),
    **{f"trim.{kind}": ("trim", "make", kind) for kind in ("pdf", "dxf", "svg")},
    **{f"gauges.{kind}": ("gauges", "make", kind) for kind in ("dxf", "svg")},
    "former.stl": ("former", "make"),
}


@dataclass(frozen=True)
class Order:
    """What the user chooses. mask: names of print files (exports.py); language: of sheets; prices: in place
    of the printer's (prices.py)."""

    quantity: int = 1
    mask: str = "{name}-{body}"
    language: str = "en"
    prices: str = ""

    def check(self, parameters: Any) -> None:
        """Raises CurveUpsError for prices that do not do."""
        chosen_prices(self.prices, read_printer(parameters.get("printer"))["prices"])

    @property
    def data(self) -> dict[str, Any]:
        """As kit.json has it."""
        return {"quantity": self.quantity, "names": self.mask, "language": self.language,
                "prices": self.prices}


def goals() -> tuple[str, ...]:
    """The stages whose results a kit is made from."""
    return ("figures", *asked_by("verify"), *asked_by("print"), "anchoring")


def make(project: Project, job: Job) -> Results:
    """What a kit is made from, with the path from flat where that is current. Where the design is not known
    to be valid, labels, solids and files say so."""
    wanted = (*goals(), *((RISEN,) if project.out_of_date(RISEN) == () else ()))
    results = project.run(wanted, job, strict=True)
    if results.verdict.valid or results.stopped:
        return results
    name = doubtful(results.title, results.verdict.valid)
    return run_under(project, results.design.with_name(name), results.parameters, goals(), job)


def print_names(name: str, parameters: Any, kinds: Sequence[str], order: Order) -> dict[File, str]:
    """Of print files. kinds: of bodies. Raises CurveUpsError for a mask that does not do."""
    return _named(name, parameters, order, tuple(
        (kind, one.ending) for one in native.print_formats() for kind in one.wanted
        if kind in (*kinds, "print")))


def _named(name: str, parameters: Any, order: Order, wanted: tuple[File, ...]) -> dict[File, str]:
    soluble = native.support_kind(parameters).soluble
    height = 2 * parameters.get("H_pin") + parameters.get("H_body")
    return file_names(name, Choice(wanted, order.mask), {
        "material": lambda kind: "soluble" if kind == "support" and soluble else "rigid",
        "thickness": lambda kind: f"{height:g}mm", "quantity": lambda kind: f"{order.quantity}x"})


def write_kit(results: Results, path: Path, job: Job, order: Order = Order(),
              risen: Mapping[str, Any] = MappingProxyType({})) -> bool:
    """Writes all files of a kit; whether that was stopped. kit.json goes first and comes last: what it does
    not list, this run did not write. risen: what is known of the path from flat, where results don't have
    it."""
    design = native.write_design(results.design.with_name(plain(results)))
    names = print_names(results.name, results.parameters, results["solids"].kinds, order)
    report = build_report(results, results.rows(), False, {}, {})
    if risen:
        report.setdefault("actuation", risen)

    def named(file: File) -> str:
        return _named(results.name, results.parameters, order, (file,))[file]

    kit = Kit(results, report, order.quantity, names, named, say=Language(order.language),
              prices=order.prices)
    stopped = results.stopped
    readings = f"{results.name}-{MEASURED}"
    filled_in = _is_changed(path, f"{COUPONS}/{readings}")
    earlier = [name for name in _listed(path) if Path(name).name == name and not _is_changed(path, name)]
    with Folder(path) as folder, Folder(path / COUPONS) as coupons:
        folder.remove(KIT, *earlier, *(f"{results.name}-{ending}" for ending in _SHEETS),
                      *map(named, _OF_ONE_BED))
        folder.remove(*(place.name for ending in _OF_BEDS
                        for place in folder.path.glob(f"{glob.escape(results.name)}-{ending}")))
        coupons.remove(*(place.name for place in coupons.path.glob(f"{glob.escape(results.name)}-*")
                         if place.suffix in _OF_COUPONS), *(() if filled_in else (readings,)))
        keep_design(folder, results, design)

        doing, done, count, reached = "", 0, 1, -1.0

        def go_on(part: float = -1.0) -> None:
            """part: of what is being done. Files count alike, and the whole never goes back."""
            nonlocal reached
            if part >= 0 or count > 1:
                reached = max(reached, (done + min(max(part, 0.0), 1.0)) / count)
            job.go_on(doing, reached)

        def begin(what: str, number: int = 0, of: int = 1) -> None:
            nonlocal doing, done, count, reached
            reached = reached if number else -1.0
            doing, done, count = what, number, of
            go_on()

        kit.go_on = go_on
        try:
            if (borders := kit.borders)["pairs"]:
                report["borders"] = borders
            begin("dividing the print among beds")
            if kit.beds:
                report["beds"] = kit.beds.figures(kit.printer)
                report["print"] = {**report["print"], **amounts(kit.prints)}
            begin("estimating hours and price")
            report["costs"] = costs(kit)
            todo = [*_print_files(kit, names), *_drawn_files(kit)]
            todo += [(f"{COUPONS}/{name}", _holding(made))
                     for name, made in import_module(".coupon_sheet", __package__).files(kit).items()
                     if name != readings or not filled_in]
            for number, (name, writer) in enumerate(todo):
                begin(f"writing {name}", number, len(todo))
                into = coupons if name.startswith(f"{COUPONS}/") else folder
                into.write(Path(name).name, writer)
                data = (path / name).read_bytes()
                kit.files[name] = {"bytes": len(data), "sha256": _sum(data)}
        except (Stopped, native.Cancelled):
            stopped = True
        folder.write_text(KIT, to_text(_contents(kit, design, stopped, order)))
    return stopped


Writer = Callable[[Path], object]


def _print_files(kit: Kit, names: Mapping[File, str]) -> Iterator[tuple[str, Writer]]:
    """What the shop prints, by the names of files: the whole, then beds, where there are several."""
    for (kind, ending), name in names.items():
        yield name, _body(kit, kind, ending)
    for name, made in import_module(".bed_files", __package__).files(kit).items():
        yield name, _holding(made)
    if not kit.beds:
        shop = import_module(".print_shop", __package__)
        yield kit.named(_OF_ONE_BED[0]), _holding(partial(shop.project, kit))
        for body, ending in _OF_ONE_BED[1:] if has_bridges(kit.results.parameters) else ():
            yield kit.named((body, ending)), _holding(partial(shop.fused, kit, ending))


def _drawn_files(kit: Kit) -> Iterator[tuple[str, Writer]]:
    """What follows the print: the order first, which lists what comes before it."""
    for ending, (module, function, *given) in _SHEETS.items():
        made = getattr(import_module(f".{module}", __package__), function)
        yield f"{kit.name}-{ending}", _holding(partial(made, kit, *given))


def _body(kit: Kit, kind: str, ending: str) -> Writer:
    return lambda place: kit.model.write(ending, kind, str(place),
                                         lambda what, part: kit.asked(part=part))


def _holding(made: Callable[[], bytes]) -> Writer:
    return lambda place: place.write_bytes(made())


def _is_changed(folder: Path, name: str) -> bool:
    """Whether a file is there that is not as the kit in this folder wrote it: readings that nobody wants to
    lose."""
    place, known = folder / name, _listed(folder).get(name, "")
    try:
        return place.exists() and bool(known != _sum(place.read_bytes()))
    except OSError:
        return True


def _listed(folder: Path) -> dict[str, str]:
    """Checksums of the files of the last kit in a folder, by their names."""
    try:
        files = json.loads((folder / KIT).read_text("utf-8"))["files"]
        return {name: about["sha256"] for name, about in files.items()}
    except (OSError, ValueError, LookupError, TypeError, AttributeError):
        return {}


def _contents(kit: Kit, design: str, stopped: bool, order: Order) -> dict[str, Any]:
    """kit.json."""
    report, parameters = kit.report, kit.results.parameters
    printed = {name: value for name, value in report["print"].items() if name != "files"}
    blocks = ("beds", "costs", "area", "solids", "sheets", "anchors", "contact_forces", "worst_contacts",
              "joints", "borders", "actuation")
    return {"format": FORMAT, "version": VERSION, "name": kit.name, "title": kit.plain_title,
            "status": "stopped" if stopped else "complete", "design_sha256": _sum(design.encode("utf-8")),
            "valid": report["valid"], "holds": report["holds"], "reasons": report["reasons"],
            **order.data, "tiles": report["tiles"], "contacts": report["contacts"],
            "cuts": report["cuts"], "print": printed,
            **{name: report[name] for name in blocks if name in report},
            "rings": kit.rings, "gauges": figures(kit.undersides),
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
    """What was chosen for the kit in a folder; the usual where there is none."""
    try:
        found = json.loads((folder / KIT).read_text("utf-8"))
        return Order(int(found["quantity"]), str(found["names"]), Language(found["language"]).name,
                     str(found.get("prices", "")))
    except (CurveUpsError, OSError, ValueError, KeyError, TypeError):
        return Order()


def is_current(folder: Path, design: str, order: Order = Order(), risen: bool = False) -> bool:
    """Whether the kit in a folder is whole and of this design (the text of design.json) and order. risen:
    whether its path from flat is known."""
    try:
        found = json.loads((folder / KIT).read_text("utf-8"))
        return bool(found["design_sha256"] == _sum(design.encode("utf-8")) and found["status"] == "complete"
                    and ("actuation" in found) == risen
                    and order.data == {name: found[name] for name in order.data})
    except (OSError, ValueError, KeyError, TypeError):
        return False
