# SPDX-License-Identifier: LGPL-2.1-or-later
"""A design and its results, each keyed by what it was made from.

run() runs the stages whose results are missing or out of date. "Out of date" is derived from the keys and
never set. One thread at a time works; others may read meanwhile.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Iterable, Iterator, Mapping, Optional, Sequence

from ..base.errors import CurveUpsError, Stopped
from ..base.findings import Finding, unique
from ..base.native import native, translated
from ..base.output import safe_name
from ..base.parameters import with_values
from ..stages import BY_NAME, SETTLED, VERDICT
from ..stages.design import FinishedDesign
from ..stages.stage import Inputs, Job, Picture, Result, Row, Stage, digest
from .keys import Key, Record, changes, differences, fixed_parameters, key_of

VERDICTS = {True: "valid", False: "not valid", None: "not judged"}
HOLDS = {True: "holds", False: "does not hold", None: "not settled"}


@dataclass(frozen=True)
class Verdict:
    """valid: None where the design was not judged. reasons: why it is not valid or not judged. holds: the
    settled shape stays; None where that is not known."""

    valid: Optional[bool] = None
    reasons: tuple[Finding, ...] = ()
    holds: Optional[bool] = None

    @property
    def word(self) -> str:
        """Words for valid and holds, which are shown together."""
        return f"{VERDICTS[self.valid]}, {HOLDS[self.holds]}"


def judge(results: Mapping[str, Any], note: Optional[Finding] = None) -> Verdict:
    """Verdict on the results of a run. note: why there is no verification."""
    holds = results[SETTLED].holds if SETTLED in results else None
    reasons = [reason for result in results.values() for reason in result.reasons()]
    verification = results.get(VERDICT)
    if verification is not None and reasons and not verification.failure:
        reasons += [advice for result in results.values() for advice in result.advice()]
    if reasons:
        return Verdict(False, unique(reasons), holds)
    if verification is not None and verification.valid:
        notes = [getattr(result, "note", None) for name, result in results.items()
                 if name in BY_NAME and BY_NAME[name].judges]
        open_questions = tuple(note for note in notes if note)  # left by a stop
        return Verdict(None if open_questions else True, open_questions, holds)
    note = verification.note if verification is not None else note
    return Verdict(None, (note,) if note else (), holds)


@dataclass(frozen=True)
class Made:
    """A result with its key and the time of making it."""

    result: Result
    key: Key = field(default_factory=dict)
    seconds: float = 0.0

    @cached_property
    def content(self) -> str:
        """Digest by which later stages know it."""
        return self.result.content or digest(*(f"{name}={value}" for name, value in sorted(self.key.items())))

    @cached_property
    def fixes(self) -> Mapping[str, Any]:
        """Parameters that it fixes for later stages."""
        return self.result.fixes()

    @property
    def record(self) -> Record:
        """Record without the result, for documents."""
        return Record(self.key, self.content, self.fixes)


@dataclass(frozen=True)
class Results(Mapping[str, Any]):
    """Results of one run in the order of the stages, an immutable value for reports, files and documents."""

    name: str             # of files
    parameters: Any
    made: Mapping[str, Made]
    note: Optional[Finding] = None  # why there is no verdict, where none was asked for
    stopped: bool = False

    def __getitem__(self, name: str) -> Any:
        return self.made[name].result

    def __iter__(self) -> Iterator[str]:
        return iter(self.made)

    def __len__(self) -> int:
        return len(self.made)

    @property
    def design(self) -> Any:
        """The native Design under the run's parameters."""
        return self["design"].design.with_parameters(self.parameters)

    @property
    def title(self) -> str:
        """Name of the design, or else of its target, in any letters."""
        if "design" in self and self["design"].design:
            return self["design"].design.name
        return self["source"].name if "source" in self else self.name

    @property
    def verdict(self) -> Verdict:
        return judge(self, self.note)

    def warnings(self) -> list[Finding]:
        return [warning for result in self.values() for warning in result.warnings()]

    def pictures(self) -> list[Picture]:
        return [picture for result in self.values() for picture in result.pictures()]

    def rows(self) -> list[Row]:
        """Rows of the stages that ran, in order; rows of one name are summed at the last place."""
        rows: dict[str, Row] = {}
        for made in self.made.values():
            for row in made.result.rows(made.seconds):
                before = rows.pop(row.name, None)
                rows[row.name] = Row(row.name, row.seconds + (before.seconds if before else 0.0),
                                     row.iterations)
        return list(rows.values())


class Project:
    """given: results that are not made: "source" and "cut request" of a target, or a "design". where: the
    target or file, for messages. known: saved results, or those of another project; results of other inputs
    are out of date here."""

    def __init__(self, name: str, parameters: Any, given: Mapping[str, Result], where: str = "",
                 known: Mapping[str, Made] | None = None):
        self.name, self.where = name, where
        # Both are replaced whole, never changed: other threads may read them at any time.
        self._given: Mapping[str, Made] = {key: Made(result) for key, result in given.items()}
        self._made: Mapping[str, Made] = dict(known or {})
        self._parameters = self._checked(parameters)

    @classmethod
    def of_design(cls, design: Any, where: str = "") -> "Project":
        """Project of a native Design."""
        return cls(safe_name(design.name), design.parameters, {"design": FinishedDesign(design)}, where)

    @property
    def parameters(self) -> Any:
        """A copy. Setting values that contradict one another raises CurveUpsError."""
        return native.Parameters(self._parameters)

    @parameters.setter
    def parameters(self, parameters: Any) -> None:
        self._parameters = self._checked(parameters)

    def give(self, name: str, result: Result) -> None:
        """Replaces a given result."""
        self._given = {**self._given, name: Made(result)}

    def copy(self) -> "Project":
        """Project with the same inputs and results. Its runs do not change this one."""
        twin = Project(self.name, self._parameters, {}, self.where, self._made)
        twin._given = self._given
        return twin

    def forget(self, names: Iterable[str]) -> None:
        """Drops results of stages, so that they are made anew."""
        dropped = set(names)
        self._made = {name: made for name, made in self._made.items() if name not in dropped}

    def given(self) -> Mapping[str, Made]:
        """Given results."""
        return self._given

    def made(self) -> Mapping[str, Made]:
        """All results, out of date or not, to be saved or `known` to other projects."""
        return self._made

    def latest(self, name: str) -> Any:
        """Last result of a stage, out of date or not; or None."""
        made = self._given.get(name) or self._made.get(name)
        return made.result if made else None

    def out_of_date(self, name: str) -> Optional[tuple[str, ...]]:
        """Names of changed inputs of a result (keys.changes); empty where it is current, None without it."""
        given = self._given
        return changes(name, {**self._made, **given}, self._parameters, given)

    def run(self, goals: Sequence[str], job: Optional[Job] = None, strict: bool = False,
            note: Optional[Finding] = None) -> Results:
        """Makes the goals with their upstream results, and returns all results.

        A stage that fails or is stopped ends in its result for that (Stage.on_failure, on_stop), if any.
        strict: failures are raised. Raises CurveUpsError, and Stopped without a result.
        """
        run = _Run(self._parameters, dict(self._given), self._made, self.where, job or Job(), strict)
        try:
            for goal in goals:
                run.make(goal)
        finally:
            self._made = {**self._made, **run.lasting}
        made = {name: run.made[name] for name in (*self._given, *BY_NAME) if name in run.made}
        stopped = run.job.stopped or any(item.result.stopped for item in made.values())
        return Results(self.name, run.decided(made), made, note, stopped)

    def _checked(self, parameters: Any) -> Any:
        values = native.Parameters(parameters)
        with translated(self.where or "parameters"):
            values.check()
        if not values.get("run_verification"):
            values.set("run_repair", False)
        return values


@dataclass
class _Run:
    """State of a run; the project gets its results at the end. before: of earlier runs."""

    parameters: Any
    made: dict[str, Made]
    before: Mapping[str, Made]
    where: str
    job: Job
    strict: bool
    lasting: dict[str, Made] = field(default_factory=dict)  # results that the project keeps

    def make(self, name: str) -> None:
        if name in self.made:
            return
        if name not in BY_NAME:
            raise CurveUpsError(f"there is no {name} to start from", self.where, "give a target")
        stage = BY_NAME[name]
        for upstream in stage.reads:
            self.make(upstream)
        key = key_of(stage, self.made, self.parameters)
        known = self.before.get(name)
        self.made[name] = known if known and not differences(known, key) else self._work(stage, key)

    def decided(self, names: Iterable[str]) -> Any:
        """Parameters for readers of these results: the project's, except those fixed by the results and their
        inputs."""
        return with_values(self.parameters, fixed_parameters(names, self.made))

    def _work(self, stage: Stage, key: Key) -> Made:
        inputs = Inputs(self.decided(stage.reads), {name: self.made[name].result for name in stage.reads},
                        self.where)
        start = time.perf_counter()
        try:
            with translated(self.where):
                if self.job.stopped:
                    raise Stopped
                self.job.stage = stage.name
                result = stage.run(inputs, self.job)
        except Stopped:
            self.job.stopped = True
            if stage.on_stop is None:
                raise
            with translated(self.where):
                return Made(stage.on_stop(self.job.stage, inputs), key)
        except CurveUpsError as error:
            if stage.on_failure is None or self.strict:
                raise
            return Made(stage.on_failure(error, inputs), key, time.perf_counter() - start)
        made = self.lasting[stage.name] = Made(result, key, time.perf_counter() - start)
        return made
