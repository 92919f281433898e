# SPDX-License-Identifier: LGPL-2.1-or-later
"""What commands do to a design, as functions that work without a window too: what macros record.

A run has two halves, so that a window can put a thread between them: `prepare` says what is to be done, on
a copy of the design's project, and `finish` takes what it made into the document.
"""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Callable, Collection, Iterator, Mapping, Optional, Sequence

from ..base import profiles
from ..base.errors import CurveUpsError, Stopped
from ..base.findings import Finding
from ..base.native import native, translated
from ..base.output import Folder, safe_name
from ..kit import files as kit_files
from ..project.project import Project, Results
from ..project.size_choice import AUTOMATIC, SizeChoice, choose
from ..report import actuation
from ..report.exports import Choice, File, choices, report as write_report, write_export
from ..stages import RISEN, asked_by
from ..stages.layout import Layout
from ..stages.stage import Job
from . import live, properties, rebuild, status
from .document import Stored, take, to_store
from .status import Keys, read_keys, write_keys


@dataclass(frozen=True)
class Ran:
    """What a run made, and what a document that still holds `before` stores of it."""

    results: Results
    before: Project
    stored: Optional[Stored]


Work = Callable[[Job], Ran]


@dataclass(frozen=True)
class Run:
    """`project`: the project to run, of a Design object. `anew`: what was stopped before is not enough."""

    title: str
    goals: tuple[str, ...]
    project: Callable[[Any], Project]
    anew: bool = False
    strict: bool = False

    @property
    def of_target(self) -> bool:
        """Whether it starts from the target; otherwise there has to be a layout."""
        return self.project is live.project_of


def _repaired(design: Any) -> Project:
    """Starts from the layout as it stands, which may have been repaired or stopped before."""
    standing, stored = live.design_project_of(design), live.stored(design)
    finished = standing.latest("design")
    layout = stored.latest("layout") or Layout(
        finished.design, False, {"converged": True, "iterations": 0, "energies": {}}, 0.0)
    given = {name: result for name in ("source", "target", "cuts") if (result := stored.latest(name))}
    given["layout"] = replace(layout, design=finished.design)
    parameters = native.Parameters(standing.parameters)
    parameters.set("self_shaping", design.SelfShaping)  # of the layout's parameters, repair's alone
    return Project(standing.name, parameters, given, standing.where)


RUNS = {
    "divide": Run("Divide", ("target smoothing",), live.project_of),
    "check": Run("Check", asked_by("check"), live.project_of),
    "find_sizes": Run("Find Sizes", asked_by("check", "sizes"), live.project_of),
    "solve": Run("Solve", asked_by("solve", "settle"), live.project_of, anew=True),
    "verify": Run("Verify", asked_by("verify"), live.design_project_of),
    "repair": Run("Repair", ("design", *asked_by("verify")), _repaired),
    "actuate": Run("Actuate", asked_by("actuate"), live.design_project_of, anew=True),
    "build_solids": Run("Build Solids", rebuild.GOALS, live.design_project_of, strict=True),
}
_made: dict[tuple[str, str, str], Any] = {}  # by a thread, for the function that is called next


def prepare(which: str, design: Any) -> tuple[Project, Work]:
    """The work of a run, for any thread: it touches no document; and the project that it is done on, whose
    target is there as soon as it is made. Raises CurveUpsError where there is nothing to start from or a
    property can't be used."""
    run, before = RUNS[which], live.stored(design)
    project = run.project(design).copy()
    if run.anew:
        project.forget_stopped()

    def work(job: Job) -> Ran:
        if run.anew and run.of_target:
            project.run(("pin smoothing",), job)
            project.forget_out_of_date()  # a picture shows what is there
        results = project.run(run.goals, job, strict=run.strict)
        return Ran(results, before, None if which == "build_solids" else to_store(before, results))

    return project, work


def hand_over(which: str, design: Any, made: Any) -> None:
    """What a thread has made, for the function of its name, which then does not work again."""
    _made[which, design.Document.Name, design.Name] = made


def _made_by(which: str, design: Any, work: Callable[[], Callable[[Job], Any]]) -> Any:
    """What a thread has handed over, or what the work makes now."""
    made = _made.pop((which, design.Document.Name, design.Name), None)
    return work()(Job()) if made is None else made


def divide(design: Any) -> Results:
    """The target, divided into tiles: what cuts run along."""
    return _run("divide", design)


def check(design: Any) -> Results:
    """Margins of the target's tiles, and what is in their way: "feasibility" of the results."""
    return _run("check", design)


def find_sizes(design: Any) -> Results:
    """The same, and limits of sizes: "sizes" of the results."""
    return _run("find_sizes", design)


def choose_sizes(design: Any, names: Collection[str] = AUTOMATIC) -> SizeChoice:
    """Sets the length L of the tiles, their thickness H_body or both to what `auto` is on the command line
    (size_choice.choose). Raises CurveUpsError where there are none, or where an expression says what they
    are."""
    found: SizeChoice = _made_by("choose_sizes", design, lambda: sizes_work(design, names))
    with transaction(design.Document, "Choose Sizes"):
        for name, value in found.values.items():
            properties.write_parameter(design, name, value)
    return found


def sizes_work(design: Any, names: Collection[str]) -> Callable[[Job], SizeChoice]:
    """The same for any thread; nothing is set."""
    refuse_bound(design, names)
    project = live.project_of(design).copy()
    return lambda job: choose(project, names, job)


def refuse_bound(design: Any, names: Collection[str]) -> None:
    """Raises CurveUpsError where an expression says what one of these parameters is: it would win."""
    bound = {path.lstrip(".") for path, _ in design.ExpressionEngine}
    for name in map(properties.property_name, names):
        if name in bound:
            raise CurveUpsError(f"{name} follows an expression", design.Label, "take the expression away")


def apply_profile(design: Any, name: str) -> None:
    """Sets the parameters that suit a kind of printer (profiles.py), and leaves the others alone; "" sets
    those that any profile names to their defaults."""
    paths = [profiles.profile_path(one) for one in profiles.profile_names()]
    values = profiles.parameters(profiles.profile_path(name)) if name else profiles.defaults(paths)
    _apply(design, "Apply Profile", values)


def apply_material(design: Any, kind: str, name: str) -> None:
    """Sets the parameters of a material, of one of profiles.MATERIALS."""
    _apply(design, "Apply Material", profiles.of_material(kind, name, design.Label))


def _apply(design: Any, step: str, values: Mapping[str, Any]) -> None:
    refuse_bound(design, values)
    with transaction(design.Document, step):
        for parameter, value in values.items():
            properties.write_parameter(design, parameter, value)


def solve(design: Any) -> Results:
    """From the target to a verified and, where it is weak, repaired layout."""
    return _run("solve", design)


def verify(design: Any) -> Results:
    """The verdict on the layout as it stands, under the geometry and physics as they are set."""
    return _run("verify", design)


def repair(design: Any) -> Results:
    """Moves tiles and pins of the layout as it stands until weak contacts hold."""
    return _run("repair", design)


def actuate(design: Any) -> Results:
    """The path of the layout as it stands from flat to shape: "actuation" of the results."""
    return _run("actuate", design)


def write_frame(design: Any, path: str, number: int = -1) -> None:
    """The tiles where a frame of the path from flat has them, by default the last, as a STEP file."""
    _made_by("write_frame", design, lambda: frame_work(design, path, number))


def frame_work(design: Any, path: str, number: int) -> Callable[[Job], bool]:
    """The same for any thread."""
    found = live.stored(design).latest(RISEN)
    if found is None:
        raise CurveUpsError("there is no path yet", design.Label, "run Actuate")
    count = len(found.time)
    if not -count <= number < count:
        raise CurveUpsError(f"there is no frame {number}", design.Label, f"give one of 0 to {count - 1}")
    where = Path(path)

    def work(job: Job) -> bool:
        bodies = Project.of_design(found.design, path).run(("bodies",), job, strict=True)["bodies"]
        if bodies.model is None:
            raise Stopped
        with translated(path):
            actuation.write_frame(bodies.model, found.frame(number), Folder(where.parent), where.name, job)
        return True

    return work


def build_solids(design: Any) -> Results:
    """Tiles, support and anchors as solids; no step of undo: that would copy them all."""
    return _run("build_solids", design)


def _run(which: str, design: Any) -> Results:
    ran: Ran = _made_by(which, design, lambda: prepare(which, design)[1])
    results = ran.results
    if which == "build_solids":
        rebuild.take(design, results)
    else:
        with transaction(design.Document, RUNS[which].title):
            first = "design" not in read_keys(design).records
            take(design, results, stored=ran.stored if live.stored(design) is ran.before else None)
            if first and which == "solve" and design.Target.Source is not None:
                design.Target.Source.Visibility = False  # it would cover the layout
    return results


def export(design: Any, folder: str, files: Sequence[File] = (), mask: str = Choice.mask,
           deviation: Optional[float] = None, reports: bool = True, insist: bool = False) -> list[str]:
    """Writes files of a design: pairs of body and ending ("print", "step"), all where none are given;
    their names. Raises CurveUpsError for a design that is not as it should be printed, unless one
    insists on it: the files say so then."""
    return _made_by("export", design, lambda: export_work(design, folder, Choice(
        tuple(files) or tuple(choices()), mask, deviation, reports, doubts(design), insist)))


def export_work(design: Any, folder: str, choice: Choice) -> Callable[[Job], list[str]]:
    """The same for any thread."""
    project = live.design_project_of(design).copy()
    project.name = file_name(design)
    return lambda job: list(write_export(project, Path(folder), choice, job).files)


def report(design: Any, folder: str) -> str:
    """Writes report.html and report.json into a folder; the page's path."""
    return _made_by("report", design, lambda: report_work(design, folder))


def report_work(design: Any, folder: str) -> Callable[[Job], str]:
    """The same for any thread."""
    project, found = live.project_of(design).copy(), doubts(design)
    if project.out_of_date("design") != ():
        project = live.design_project_of(design).copy()
    project.name = file_name(design)
    return lambda job: str(write_report(project, Path(folder), found, job))


@dataclass(frozen=True)
class WrittenKit:
    """page: of its assembly. keys: what it was made from; none where it was there already."""

    page: str
    keys: Optional[Keys] = None


def kit(design: Any, folder: str, quantity: int = 1, mask: str = kit_files.Order.mask, language: str = "en"
        ) -> str:
    """Writes the fabrication kit into a folder, unless it holds that of the design as it is; the page of its
    assembly."""
    written: WrittenKit = _made_by("kit", design, lambda: kit_work(
        design, folder, kit_files.Order(quantity, mask, language)))
    if written.keys is not None:
        write_keys(design, written.keys, "KitKeys")
        design.Proxy.refresh(design)
    return written.page


def kit_work(design: Any, folder: str, order: kit_files.Order) -> Callable[[Job], WrittenKit]:
    """The same for any thread."""
    project = live.design_project_of(design).copy()
    project.name = file_name(design)
    current = status.status_of(design).kit[0] == status.CURRENT

    def work(job: Job) -> WrittenKit:
        finished = project.latest("design").design.with_parameters(project.parameters)
        page = Path(folder) / f"{project.name}-assembly.html"
        text = native.write_design(finished)
        if current and kit_files.is_current(Path(folder), text, order) and page.exists():
            return WrittenKit(str(page))
        results = kit_files.make(project, job)
        if job.stopped or kit_files.write_kit(results, Path(folder), job, order):
            raise Stopped
        records = {name: results.made[name].record for name in kit_files.goals()}
        return WrittenKit(str(page), Keys(records))

    return work


def doubts(design: Any) -> tuple[Finding, ...]:
    """Why the design should not be printed as it is; none for one that nobody has judged."""
    found = design.Proxy.state(design)
    if found.state not in (status.OUT_OF_DATE, status.INVALID):
        return ()
    return (Finding.about("doubt", (tile for reason in found.reasons for tile in reason.tiles),
                          state=found.state, reasons=found.reasons),)


def file_name(design: Any) -> str:
    """What files of a design are called."""
    return safe_name(design.Label)


@contextmanager
def transaction(document: Any, text: str) -> Iterator[None]:
    """One step of undo; taken back where the work inside raises. The document is the active one meanwhile:
    FreeCAD would give an active one of its own a step that is called "-> text"."""
    import FreeCAD

    active = FreeCAD.ActiveDocument
    if active is None or active.Name != document.Name:
        FreeCAD.setActiveDocument(document.Name)
    document.openTransaction(text)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    else:
        document.commitTransaction()
    finally:
        if active is not None and active.Name != document.Name:
            FreeCAD.setActiveDocument(active.Name)
