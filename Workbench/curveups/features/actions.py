# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands on a design as functions, with and without a window: macros record their calls.

A run has two halves, so that a window can put a thread between them. `prepare` returns the work, on a copy of
the design's project; the function of the run stores its value in the document. A window hands that value over
(`hand_over`) before it calls the function.
"""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Callable, Collection, Iterator, Mapping, Optional, Sequence

from ..base import profiles
from ..base.errors import CurveUpsError, Stopped
from ..base.findings import Finding
from ..base.native import native
from ..base.output import safe_name
from ..kit import files as kit_files
from ..project.following import carry_along
from ..project.project import Project, Results
from ..project.size_choice import AUTOMATIC, SizeChoice, choose
from ..report.exports import Choice, File, choices, report as write_report, write_export
from ..stages import BY_NAME, SETTLED, stages_of
from ..stages.layout import Layout
from ..stages.stage import Job
from . import properties, status
from .design import SOLIDS, design_project_of, earlier_tiles, project_of, stored, take_solids
from .document import take
from .parts import request_of
from .status import Keys, read_keys, write_keys


Work = Callable[[Job], Results]


@dataclass(frozen=True)
class Run:
    """`project`: of a Design, to run. `anew`: results that were stopped are made again."""

    title: str
    goals: tuple[str, ...]
    project: Callable[[Any], Project]
    anew: bool = False
    strict: bool = False

    @property
    def of_target(self) -> bool:
        """True for a run that starts from the target; others need a layout."""
        return self.project is project_of


def _repaired(design: Any) -> Project:
    """Project of a repair of the layout as it stands, which may have been repaired or stopped before."""
    standing, results = design_project_of(design), stored(design)
    finished = standing.latest("design")
    layout = results.latest("layout") or Layout(
        finished.design, False, {"converged": True, "iterations": 0, "energies": {}}, 0.0)
    given = {name: result for name in ("source", "target", "cuts") if (result := results.latest(name))}
    given["layout"] = replace(layout, design=finished.design)
    parameters = native.Parameters(standing.parameters)
    parameters.set("self_shaping", design.SelfShaping)  # of the layout's parameters, repair's alone
    return Project(standing.name, parameters, given, standing.where)


RUNS = {
    "divide": Run("Divide", ("target smoothing",), project_of),
    "check": Run("Check", stages_of("check"), project_of),
    "find_sizes": Run("Find Sizes", stages_of("check", "sizes"), project_of),
    "solve": Run("Solve", stages_of("solve", "settle"), project_of, anew=True),
    "tile_anew": Run("Tile Anew", stages_of("solve", "settle"), project_of, anew=True),
    "verify": Run("Verify", stages_of("verify"), design_project_of),
    "repair": Run("Repair", ("design", *stages_of("verify")), _repaired),
    "actuate": Run("Actuate", stages_of("actuate"), design_project_of, anew=True),
    "build_solids": Run("Build Solids", SOLIDS, design_project_of, strict=True),
}
_handed_over: dict[tuple[str, str, str], Any] = {}  # values of a thread's work, by function and design


def prepare(which: str, design: Any, settles: bool = True) -> tuple[Project, Work]:
    """Project of a run, and the work on it, for any thread: it touches no document. settles: False leaves
    settled forces out, unless the verdict depends on them. Raises CurveUpsError where there is nothing to
    start from or a property can't be used."""
    run = RUNS[which]
    project = run.project(design).copy()
    if run.anew:
        project.forget(name for name, made in project.made().items() if made.result.stopped)
    earlier = earlier_tiles(design, project) if run.of_target and which != "tile_anew" else None
    if which == "tile_anew":
        project.forget(["target"])
        project.give("cut request", request_of(design.Cuts, by_number=False))
    goals = tuple(name for name in run.goals
                  if settles or name != SETTLED or BY_NAME[name].contributes(project.parameters))

    def work(job: Job) -> Results:
        if earlier is not None:
            carry_along(project, earlier, job)
        if run.anew and run.of_target:
            project.run(("pin smoothing",), job)
            project.forget(filter(project.out_of_date, project.made()))  # pictures would show them
        return project.run(goals, job, strict=run.strict)

    return project, work


def hand_over(which: str, design: Any, value: Any) -> None:
    """Store the value of a thread's work for the function of its name, which then does not work again."""
    _handed_over[which, design.Document.Name, design.Name] = value


def _value_of(which: str, design: Any, work: Callable[[], Callable[[Job], Any]]) -> Any:
    """Value of a thread's work, or of the work done now."""
    value = _handed_over.pop((which, design.Document.Name, design.Name), None)
    return work()(Job()) if value is None else value


def divide(design: Any) -> Results:
    """Divide the target into tiles: cuts run along their edges."""
    return _run("divide", design)


def check(design: Any) -> Results:
    """Compute margins and obstacles of the target's tiles: "feasibility" of the results."""
    return _run("check", design)


def find_sizes(design: Any) -> Results:
    """Check, and compute limits of sizes: "sizes" of the results."""
    return _run("find_sizes", design)


def choose_sizes(design: Any, names: Collection[str] = AUTOMATIC) -> SizeChoice:
    """Set the length L of the tiles, their thickness H_body or both to the values of `auto` on the command
    line (size_choice.choose). Raises CurveUpsError where there are none, or where they follow an
    expression."""
    choice: SizeChoice = _value_of("choose_sizes", design, lambda: sizes_work(design, names))
    _set(design, "Choose Sizes", choice.values)
    return choice


def sizes_work(design: Any, names: Collection[str]) -> Callable[[Job], SizeChoice]:
    """Work of choose_sizes, for any thread; it sets nothing."""
    refuse_bound(design, names)
    project = project_of(design).copy()
    return lambda job: choose(project, names, job)


def refuse_bound(design: Any, names: Collection[str]) -> None:
    """Raise CurveUpsError where one of these parameters follows an expression, which would win."""
    bound = {path.lstrip(".") for path, _ in design.ExpressionEngine}
    for name in map(properties.property_name, names):
        if name in bound:
            raise CurveUpsError(f"{name} follows an expression", design.Label, "take the expression away")


def apply_profile(design: Any, name: str) -> None:
    """Set the parameters of a kind of printer (profiles.py), and leave the others alone; "" sets those that
    any profile names to their defaults."""
    paths = list(map(profiles.profile_path, profiles.profile_names()))
    values = profiles.parameters(profiles.profile_path(name)) if name else profiles.defaults(paths)
    refuse_bound(design, values)
    _set(design, "Apply Profile", values)


def apply_material(design: Any, kind: str, name: str) -> None:
    """Set the parameters of a material, of one of profiles.MATERIALS."""
    values = profiles.of_material(kind, name, design.Label)
    refuse_bound(design, values)
    _set(design, "Apply Material", values)


def _set(design: Any, step: str, values: Mapping[str, Any]) -> None:
    """Set parameters in one step of undo. Solids follow outside of it."""
    with transaction(design.Document, step):
        for parameter, value in values.items():
            properties.write_parameter(design, parameter, value)
    design.Document.recompute()


def solve(design: Any) -> Results:
    """Lay out the target, verify the layout and repair weak contacts."""
    return _run("solve", design)


def tile_anew(design: Any) -> Results:
    """Solve with new tiles, which do not follow the earlier ones; cuts keep their places."""
    return _run("tile_anew", design)


def verify(design: Any) -> Results:
    """Judge the layout as it stands, under the present geometry and physics."""
    return _run("verify", design)


def repair(design: Any) -> Results:
    """Move tiles and pins of the layout as it stands until weak contacts hold."""
    return _run("repair", design)


def actuate(design: Any) -> Results:
    """Compute the path of the layout from flat to shape: "actuation" of the results."""
    return _run("actuate", design)


def build_solids(design: Any) -> Results:
    """Build the solids of tiles, support and anchors. This is no step of undo, which would copy them all."""
    return _run("build_solids", design)


def _run(which: str, design: Any) -> Results:
    results: Results = _value_of(which, design, lambda: prepare(which, design)[1])
    if which == "build_solids":
        take_solids(design, results)
    else:
        with transaction(design.Document, RUNS[which].title):
            first = "design" not in read_keys(design).records
            take(design, results)
            if first and which == "solve" and design.Target.Source is not None:
                design.Target.Source.Visibility = False  # it would cover the layout
    return results


def export(design: Any, folder: str, files: Sequence[File] = (), mask: str = Choice.mask,
           deviation: Optional[float] = None, reports: bool = True, insist: bool = False) -> list[str]:
    """Write files of a design: pairs of body and ending ("print", "step"), all where none are given. Return
    their names. Raises CurveUpsError for a design that should not be printed as it is; `insist` writes files
    that say so."""
    return _value_of("export", design, lambda: export_work(design, folder, Choice(
        tuple(files) or tuple(choices()), mask, deviation, reports, doubts(design), insist)))


def export_work(design: Any, folder: str, choice: Choice) -> Callable[[Job], list[str]]:
    """Work of export, for any thread."""
    project = design_project_of(design).copy()
    project.name = file_name(design)
    return lambda job: list(write_export(project, Path(folder), choice, job).files)


def report(design: Any, folder: str) -> str:
    """Write report.html and report.json into a folder. Return the page's path."""
    return _value_of("report", design, lambda: report_work(design, folder))


def report_work(design: Any, folder: str) -> Callable[[Job], str]:
    """Work of report, for any thread."""
    project, doubted = project_of(design).copy(), doubts(design)
    if project.out_of_date("design") != ():
        project = design_project_of(design).copy()
    project.name = file_name(design)
    return lambda job: str(write_report(project, Path(folder), doubted, job))


def kit(design: Any, folder: str, quantity: int = 1, mask: str = kit_files.Order.mask, language: str = "en"
        ) -> str:
    """Write the fabrication kit into a folder. Return the path of the assembly's page."""
    page, keys = _value_of("kit", design, lambda: kit_work(
        design, folder, kit_files.Order(quantity, mask, language)))
    write_keys(design, keys, "KitKeys")
    status.refresh(design)
    return str(page)


def kit_work(design: Any, folder: str, order: kit_files.Order) -> Callable[[Job], tuple[str, Keys]]:
    """Work of kit, for any thread: the page of its assembly, and keys of what it was made from."""
    project = design_project_of(design).copy()
    project.name = file_name(design)

    def work(job: Job) -> tuple[str, Keys]:
        results = kit_files.make(project, job)
        if job.stopped or kit_files.write_kit(results, Path(folder), job, order):
            raise Stopped
        records = {name: results.made[name].record for name in kit_files.goals()}
        return str(Path(folder) / f"{project.name}-assembly.html"), Keys(records)

    return work


def doubts(design: Any) -> tuple[Finding, ...]:
    """Finding why the design should not be printed as it is; none for one that nobody has judged."""
    now = status.status_of(design)
    if now.state not in (status.OUT_OF_DATE, status.INVALID):
        return ()
    return (Finding.about("doubt", (tile for reason in now.reasons for tile in reason.tiles),
                          state=now.state, reasons=now.reasons),)


def file_name(design: Any) -> str:
    """Name of a design's files."""
    return safe_name(design.Label)


@contextmanager
def transaction(document: Any, text: str) -> Iterator[None]:
    """Make the work inside one step of undo, which is taken back where it raises. The document is the active
    one meanwhile: FreeCAD would give another active one a step called "-> text"."""
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
