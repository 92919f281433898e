# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a target surface to a finished design: arrays in, arrays out, no FreeCAD.

target -> remesh -> (cuts) -> relief -> layout -> solids -> verify -> repair -> check -> (cuts). Each stage is one function, timed by
`_stage`; what it finds is kept in an `Outcome`, from which reports, files and documents are made. Cuts are looked for before
the layout where they were asked for, and at the end for a design that needs them.
"""

from __future__ import annotations

import time
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, Optional

import numpy as np

from . import suggestions
from .cuts import CutRequest, resolve_cuts
from .errors import CurveUpsError, Stopped, from_native, tile_list
from .native import native
from .progress import Progress
from .solids import SolidFigures, measure
from .verdict import Verdict, judge


# Findings of check_mesh after which a mesh has no edge lengths worth speaking of.
BROKEN = ("empty", "index-out-of-range", "not-finite")


@dataclass
class Request:
    """What is to be designed. V and F: the target, as read (mm after `scale`)."""

    name: str
    V: np.ndarray
    F: np.ndarray
    parameters: Any
    cuts: CutRequest = field(default_factory=CutRequest)
    auto_cuts: int = 0  # how many suggested cuts are made besides
    remesh: bool = True
    solids: bool = True
    where: str = ""  # names the target in messages


@dataclass
class Stage:
    name: str
    seconds: float
    iterations: int = 0


@dataclass
class Target:
    """The mesh that becomes tiles, and what it was made from."""

    V: np.ndarray
    F: np.ndarray
    source_V: np.ndarray
    source_F: np.ndarray
    mean_edge: float
    edge_cv: float
    sagitta: float = 0.0
    notes: list[str] = field(default_factory=list)


@dataclass
class Outcome:
    """All that is known about a design once the stages have run."""

    name: str
    design: Any
    figures: Any                             # native DesignFigures
    target: Optional[Target] = None
    layout: Any = None                       # native LayoutResult
    verification: Any = None                 # native ValidationReport
    verify_note: str = ""                    # why there is none
    verify_failure: str = ""                 # why there is none though it was wanted: not valid
    recheck: Any = None                      # native ValidationReport at half the mesh size
    relief: Any = None                       # native PinRelief, where vertices moved for pins
    repair: Any = None                       # native RepairResult, where weak contacts were repaired
    model: Any = None                        # native PrintModel
    solids: Optional[SolidFigures] = None
    stretch: Optional[dict] = None           # of the layout: suggestions.stretch_of
    suggestions: suggestions.Suggestions = field(default_factory=suggestions.Suggestions)
    stopped: bool = False
    stages: list[Stage] = field(default_factory=list)
    warnings: list[dict] = field(default_factory=list)
    verdict: Verdict = field(default_factory=Verdict)


def prepare_target(request: Request, progress: Progress, stages: list[Stage],
                   warnings: list[dict]) -> Target:
    """Cleans, checks and remeshes the target; sets L to the mesh's own where it is kept."""
    parameters = request.parameters
    with _stage(stages, "remesh", request.where):
        progress("checking the target", -1.0)
        V, F = _scaled(request)
        notes: list[str] = []
        if request.remesh:
            # Otherwise the mesh is taken as it is: cuts name its vertices by number.
            clean = native.clean_mesh(V, F)
            V, F, notes = clean.V, clean.F, list(clean.notes)
        else:
            _refuse(native.check_mesh(V, F, 1.0, True), request.where, BROKEN)
            parameters.set("L", _own_length(V, F, request.where))
        findings = native.check_mesh(V, F, parameters.get("L"),
                                     bool(request.cuts) or request.auto_cuts > 0)
        notes += [finding.message for finding in findings if finding.kind == "components"]
        _report([f for f in findings if f.kind != "components"], warnings, request.where)
        if not request.remesh:
            lengths = _edge_lengths(V, F)
            return Target(V, F, V, F, float(lengths.mean()),
                          float(lengths.std() / lengths.mean()), 0.0, notes)
        made = native.remesh(V, F, parameters.get("L"), progress)
        return Target(made.V, made.F, V, F, made.mean_edge, made.edge_cv, made.sagitta, notes)


def run_design(request: Request, progress: Progress) -> Outcome:
    """All stages. Stops early, with what there is, once `progress` says so after the layout."""
    parameters, stages, warnings = request.parameters, [], []
    with _errors(request.where):
        parameters.check()
    target = prepare_target(request, progress, stages, warnings)
    _go_on(progress, "cutting")
    with _errors(request.where):
        cuts = resolve_cuts(request.cuts, target.V, target.F)
        _report(native.check_target(target.V, target.F, cuts, parameters), [], request.where,
                tiles=True)
    applied = []
    if request.auto_cuts:
        with _stage(stages, "cuts", request.where):
            found = native.suggest_cuts(target.V, target.F, cuts, parameters, request.auto_cuts,
                                        progress=progress)
            if found.stopped:
                raise Stopped
            applied = list(found.cuts)
            cuts = suggestions.joined([cuts, *(cut.edges for cut in applied)])
        stages[-1].iterations = int(found.layouts)
    relief = _relieve(request, target, cuts, progress, stages)
    V = target.V if relief is None else relief.V
    with _errors(request.where):
        _report(native.check_target(V, target.F, cuts, parameters), warnings, request.where,
                tiles=True)
    with _stage(stages, "layout", request.where):
        begun = _FirstCall(progress)
        layout = native.solve_layout(request.name, V, target.F, cuts, parameters, begun)
        if relief is not None:
            layout.design.set_target(target.V, target.F)
    stages[-1].iterations = int(layout.iterations)
    stages[-1].seconds -= begun.seconds
    stages.insert(len(stages) - 1, Stage("flatten", begun.seconds))
    with _errors(request.where):
        figures = native.evaluate_design(layout.design)
    outcome = Outcome(request.name, layout.design, figures, target, layout, stages=stages,
                      warnings=warnings, stopped=bool(layout.stopped))
    outcome.suggestions.applied = applied
    outcome.relief = relief
    if request.solids:
        _build(outcome, progress, request.where)
    _verify(outcome, progress, request.where)
    if _repair(outcome, progress, request.where):
        if request.solids:
            _build(outcome, progress, request.where)
        _verify(outcome, progress, request.where)
    _recheck(outcome, progress, request.where)
    if request.solids:
        _measure(outcome, progress, request.where)
    _suggest(outcome, progress, request.where)
    outcome.verdict = judge(outcome)
    return outcome


def _relieve(request: Request, target: Target, cuts: np.ndarray, progress: Progress,
             stages: list[Stage]) -> Any:
    """Room for pins that folds leave too little of: vertices moved a little, or None."""
    parameters = request.parameters
    if not (parameters.get("repair") and parameters.get("move_vertices")):
        return None
    with _stage(stages, "relief", request.where):
        relief = native.relieve_pins(target.V, target.F, cuts, parameters, progress)
    return relief if relief.relieved else None


def run_verify(design: Any, progress: Progress, where: str) -> Outcome:
    """The physical model on a design that exists."""
    with _errors(where):
        outcome = Outcome(design.name, design, native.evaluate_design(design))
    _verify(outcome, progress, where, asked=True)
    _recheck(outcome, progress, where)
    outcome.verdict = judge(outcome)
    return outcome


def run_export(design: Any, progress: Progress, where: str, changed: bool) -> Outcome:
    """The solids of a design that exists; `changed` where its geometry parameters were."""
    with _errors(where):
        design.parameters.check()
        outcome = Outcome(design.name, design, native.evaluate_design(design))
    outcome.verify_note = ("geometry changed since verification" if changed
                           else "an export does not verify")
    _build(outcome, progress, where)
    _measure(outcome, progress, where)
    outcome.verdict = judge(outcome)
    return outcome


def _verify(outcome: Outcome, progress: Progress, where: str, asked: bool = False) -> None:
    if not asked and not outcome.design.parameters.get("verify"):
        outcome.verify_note = "verification was off"
        return
    if outcome.stopped or not progress("verifying", 0.0):
        outcome.stopped = True
        outcome.verify_note = "stopped before verification"
        return
    try:
        with _stage(outcome.stages, "verify", where):
            # Where printed tiles touch, whether or not solids are wanted.
            tips = (outcome.model.bump_tips if outcome.model is not None
                    else native.bump_tips(outcome.design))
            outcome.verification = native.verify_design(
                outcome.design, progress, tips,
                keep_solution=not asked and outcome.repair is None
                and bool(outcome.design.parameters.get("repair")),
                solved=None if outcome.repair is None else outcome.repair.solved)
            if outcome.verification.valid:
                outcome.verification.drop_solution()
        physics = outcome.verification.blocks.get("physics", {})
        outcome.stages[-1].iterations = sum(sum(physics.get(f"newton_iterations_{mesh}", ()))
                                            for mesh in ("coarse", "fine"))
    except Stopped:
        outcome.stopped = True
        outcome.verify_note = "stopped during verification"
    except CurveUpsError as error:
        if asked:
            raise
        # The layout is worth its files; without a verdict it must not pass for valid.
        outcome.verification = None
        outcome.verify_failure = f"the design could not be verified: {_advice(error)}"


def _recheck(outcome: Outcome, progress: Progress, where: str) -> None:
    """The verdict once more, on a membrane mesh of half the size, where that is asked for."""
    if (outcome.stopped or outcome.verification is None or not outcome.verification.valid
            or not outcome.design.parameters.get("recheck")):
        return
    try:
        with _stage(outcome.stages, "recheck", where):
            finer = native.read_design(native.write_design(outcome.design))
            size = outcome.design.parameters.get("mesh_size")
            finer.parameters.set("mesh_size", max(0.05, 0.5 * size))
            outcome.recheck = native.verify_design(finer, progress, native.bump_tips(finer))
    except Stopped:
        outcome.stopped = True
    except CurveUpsError as error:
        outcome.warnings.append({"what": "the verdict could not be had on a finer membrane mesh: "
                                         f"{_advice(error)}", "kind": "recheck", "tiles": []})


def _repair(outcome: Outcome, progress: Progress, where: str) -> bool:
    """Repairs weak contacts of a design that failed verification. True where the design changed: it is
    to be built and verified anew."""
    if (outcome.verification is None or outcome.verification.valid or outcome.stopped
            or not outcome.design.parameters.get("repair")):
        return False
    try:
        with _stage(outcome.stages, "refine", where):
            outcome.repair = native.repair_design(outcome.design, outcome.verification.solved, progress)
    except Stopped:
        outcome.stopped = True
        return False
    except CurveUpsError as error:
        outcome.verification.drop_solution()
        # No repair can begin from here: the design ends as it is, with the verdict it has.
        outcome.warnings.append({"what": f"repair can't begin: {error.what}", "kind": "repair",
                                 "tiles": []})
        return False
    outcome.verification.drop_solution()
    outcome.stages[-1].iterations = len(outcome.repair.steps)
    outcome.stopped = outcome.repair.status == "stopped"
    if native.write_design(outcome.repair.design) == native.write_design(outcome.design):
        return False
    outcome.design = outcome.repair.design
    with _errors(where):
        outcome.figures = native.evaluate_design(outcome.design)
    # The verdict was on the design as it was before.
    outcome.verification, outcome.verify_note = None, "stopped during repair"
    return not outcome.stopped


def _build(outcome: Outcome, progress: Progress, where: str) -> None:
    """The print model, before verification: it knows where bumps touch."""
    outcome.model = None
    if outcome.stopped or not progress("building solids", 0.0):
        outcome.stopped = True
        return
    try:
        with _stage(outcome.stages, "solids", where):
            model = native.make_print_model(outcome.design)
            model.build_solids(progress)
    except Stopped:
        outcome.stopped = True
        return
    outcome.model = model


def _measure(outcome: Outcome, progress: Progress, where: str) -> None:
    if outcome.stopped or not progress("checking solids", 0.0):
        outcome.stopped = True
    else:
        start = time.perf_counter()
        try:
            with _errors(where):
                outcome.solids = measure(outcome.model, outcome.design.parameters, progress)
            outcome.stages.append(Stage("check", time.perf_counter() - start))
        except Stopped:
            outcome.stopped = True
    if outcome.stopped:
        outcome.model = None


def _suggest(outcome: Outcome, progress: Progress, where: str) -> None:
    """Cuts and other remedies for a design that did not verify, or is badly stretched."""
    if outcome.stopped:
        return
    try:
        _look_for_cuts(outcome, progress, where)
    except Stopped:
        outcome.stopped = True
    except CurveUpsError as error:
        outcome.warnings.append({"what": f"cuts could not be looked for: {_advice(error)}", "kind": "cuts",
                                 "tiles": []})


def _look_for_cuts(outcome: Outcome, progress: Progress, where: str) -> None:
    with _errors(where):
        outcome.stretch = suggestions.stretch_of(outcome.design)
    stretched = suggestions.is_stretched(outcome.stretch, int(outcome.figures.contacts))
    failed = outcome.verification is not None and not outcome.verification.valid
    if not (stretched or failed or not outcome.layout.converged):
        return
    with _stage(outcome.stages, "cuts", where):
        suggestions.propose(outcome, progress)
    if stretched:
        outcome.warnings.append(suggestions.stretch_warning(outcome))


def _advice(error: CurveUpsError) -> str:
    """An error inside of another sentence."""
    return error.what + (f" ({error.remedy})" if error.remedy else "")


def _scaled(request: Request) -> tuple[np.ndarray, np.ndarray]:
    V = np.ascontiguousarray(request.V, float) * request.parameters.get("scale")
    F = np.ascontiguousarray(request.F, np.int32)
    return V, np.ascontiguousarray(F[:, ::-1]) if request.parameters.get("flip") else F


def _own_length(V: np.ndarray, F: np.ndarray, where: str) -> float:
    length = float(native.mean_edge_length(V, F))
    table = {row.name: row for row in native.parameter_table()}
    if not table["L"].minimum <= length <= table["L"].maximum:
        raise CurveUpsError(
            f"the mesh's mean edge length is {length:.4g} mm", where,
            f"tiles have {table['L'].minimum:g} to {table['L'].maximum:g} mm: "
            "set scale for another unit, or remesh")
    return length


def _edge_lengths(V: np.ndarray, F: np.ndarray) -> np.ndarray:
    pairs = np.unique(np.sort(np.vstack([F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]]]), axis=1), axis=0)
    return np.linalg.norm(V[pairs[:, 0]] - V[pairs[:, 1]], axis=1)


def _refuse(findings, where: str, kinds: tuple[str, ...]) -> None:
    """Raises for the first finding of these kinds."""
    _report([finding for finding in findings if finding.kind in kinds], [], where)


def _report(findings, warnings: list[dict], where: str, tiles: bool = False) -> None:
    """Raises the first error among findings; all others become warnings."""
    for finding in findings:
        rows = [int(row) for row in (finding.tiles if tiles else finding.faces)]
        if finding.is_error:
            names = tile_list(rows) if tiles else _faces(rows)
            place = ", ".join(part for part in (where, names) if part)
            raise CurveUpsError(finding.message, place, finding.remedy)
        warnings.append({"what": finding.message, "kind": finding.kind, "remedy": finding.remedy,
                         "tiles": rows if tiles else []})


def _faces(rows: list[int]) -> str:
    """Faces of the input, which are not the tiles to come, by their number from 1."""
    if not rows:
        return ""
    shown = ", ".join(str(row + 1) for row in rows[:6])
    return f"faces {shown}" + (f" and {len(rows) - 6} more" if len(rows) > 6 else "")


class _FirstCall:
    """A progress sink that notes when it was first called: the layout's start (geometry and
    conformal map) is a stage of its own in reports, and the optimiser reports from its first step."""

    def __init__(self, progress: Progress):
        self._progress = progress
        self._start = time.perf_counter()
        self.seconds = 0.0

    def __call__(self, what: str, fraction: float) -> bool:
        self.seconds = self.seconds or time.perf_counter() - self._start
        return self._progress(what, fraction)


def _go_on(progress: Progress, what: str) -> None:
    if not progress(what, -1.0):
        raise Stopped


@contextmanager
def _errors(where: str):
    try:
        yield
    except native.Cancelled:
        raise Stopped from None
    except native.Error as error:
        raise from_native(error, where) from error
    except MemoryError:
        raise CurveUpsError("there is not enough memory", where,
                            "use larger tiles (--set L=...) or a smaller target") from None
    except RuntimeError as error:  # of a library: the native module's own errors are handled above
        raise CurveUpsError(f"unexpected failure: {error}", where, "please report it") from error


@contextmanager
def _stage(stages: list[Stage], name: str, where: str):
    start = time.perf_counter()
    with _errors(where):
        yield
    seconds = time.perf_counter() - start
    again = next((stage for stage in stages if stage.name == name), None)
    if again is None:
        stages.append(Stage(name, seconds))
    else:  # after a repair
        again.seconds += seconds
        stages.append(stages.pop(stages.index(again)))
