# SPDX-License-Identifier: LGPL-2.1-or-later
"""A design and its results, each keyed by what it was made from.

Asking for a result runs the stages that are missing or out of date, and nothing else. "Out of date"
is derived from the keys: nobody sets it. One thread at a time works; others may read meanwhile.
"""

from __future__ import annotations

import threading
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
from .keys import Key, Record, Records, changes, differences, key_of, settled

HOLDS = {True: "holds", False: "does not hold", None: "not settled"}


@dataclass(frozen=True)
class Verdict:
    """valid is None where the design could not be judged; the reasons say why in any case. holds: whether
    the settled shape stays; None where that is not known."""

    valid: Optional[bool] = None
    reasons: tuple[Finding, ...] = ()
    holds: Optional[bool] = None

    @property
    def word(self) -> str:
        """Both, which are always shown together."""
        valid = {True: "valid", False: "not valid", None: "not judged"}[self.valid]
        return f"{valid}, {HOLDS[self.holds]}"


def judge(results: Mapping[str, Any], note: Optional[Finding] = None) -> Verdict:
    """The verdict on the results of a run. note: why there is no verification."""
    holds = results[SETTLED].holds if SETTLED in results else None
    reasons = [reason for result in results.values() for reason in result.reasons()]
    verification = results.get(VERDICT)
    if verification is not None and reasons and not verification.failure:
        reasons += [advice for result in results.values() for advice in result.advice()]
    if reasons:
        return Verdict(False, unique(reasons), holds)
    if verification is not None and verification.valid:
        # What was asked for besides and is not known, as the work was stopped.
        notes = [getattr(result, "note", None) for name, result in results.items()
                 if name in BY_NAME and BY_NAME[name].judges]
        open_questions = tuple(note for note in notes if note)
        return Verdict(None if open_questions else True, open_questions, holds)
    note = verification.note if verification is not None else note
    return Verdict(None, (note,) if note else (), holds)


@dataclass(frozen=True)
class Made:
    """A result with what it was made from and how long that took."""

    result: Result
    key: Key = field(default_factory=dict)
    seconds: float = 0.0

    @property
    def content(self) -> str:
        """What later stages know it by."""
        return self.result.content or digest(*(f"{name}={value}" for name, value in sorted(self.key.items())))

    @cached_property
    def record(self) -> Record:
        """What is known of it without itself."""
        return Record(self.key, self.content, self.result.settles())


@dataclass(frozen=True)
class Results(Mapping[str, Any]):
    """What one run ended with, in the order of the stages: a value that stays as it is whatever the
    project does next. Reports, files and documents are made from it."""

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
        """What the design, or else its target, is called, in any letters."""
        if "design" in self and self["design"].design:
            return self["design"].design.name
        return self["source"].name if "source" in self else self.name

    @property
    def verdict(self) -> Verdict:
        return judge(self, self.note)

    def warnings(self) -> list[Finding]:
        return [found for result in self.values() for found in result.warnings()]

    def pictures(self) -> list[Picture]:
        return [picture for result in self.values() for picture in result.pictures()]

    def rows(self) -> list[Row]:
        """The stages that ran, in order; one that ran again after a repair counts there, with all its
        seconds."""
        rows: dict[str, Row] = {}
        for made in self.made.values():
            for row in made.result.rows(made.seconds):
                before = rows.pop(row.name, None)
                rows[row.name] = Row(row.name, row.seconds + (before.seconds if before else 0.0),
                                     row.iterations)
        return list(rows.values())


class Project:
    """`given`: results that are not made but given: "source" and "cut request" where a target is to
    become a design, "design" where there is one. `where` names the target or file in messages. `known`:
    results of another project or saved ones; those made from something else are out of date here."""

    def __init__(self, name: str, parameters: Any, given: Mapping[str, Result], where: str = "",
                 known: Mapping[str, Made] | None = None):
        self.name, self.where = name, where
        self._given = {key: Made(result) for key, result in given.items()}
        self._made: dict[str, Made] = dict(known or {})
        self._reading, self._working = threading.Lock(), threading.RLock()
        self._parameters = self._checked(parameters)

    @classmethod
    def of_design(cls, design: Any, where: str = "") -> "Project":
        """The project of a native Design that exists."""
        return cls(safe_name(design.name), design.parameters, {"design": FinishedDesign(design)}, where)

    @property
    def parameters(self) -> Any:
        """A copy. Values that contradict one another are refused with CurveUpsError."""
        return native.Parameters(self._parameters)

    @parameters.setter
    def parameters(self, parameters: Any) -> None:
        checked = self._checked(parameters)
        with self._reading:
            self._parameters = checked

    def give(self, name: str, result: Result) -> None:
        """Another given result."""
        with self._reading:
            self._given[name] = Made(result)

    def copy(self) -> "Project":
        """Another project of the same inputs and results, which are values: whatever it runs, this one
        stays as it is."""
        with self._reading:
            twin = Project(self.name, self._parameters, {}, self.where, self._made)
            twin._given = dict(self._given)
        return twin

    def forget_stopped(self) -> None:
        """Drops what was stopped before its end: asked for again, it is made anew."""
        with self._reading:
            self._made = {name: one for name, one in self._made.items() if not one.result.stopped}

    def given(self) -> dict[str, Made]:
        """What is not made but given."""
        with self._reading:
            return dict(self._given)

    def forget_out_of_date(self) -> None:
        """Drops results that were made from something else than there is now."""
        kept = {name: one for name, one in self.made().items() if self.out_of_date(name) == ()}
        with self._reading:
            self._made = kept

    def made(self) -> dict[str, Made]:
        """All results there are, out of date or not: what is saved, and `known` to other projects."""
        with self._reading:
            return dict(self._made)

    def latest(self, name: str) -> Any:
        """The last result of a stage, out of date or not; None where there is none."""
        with self._reading:
            made = self._given.get(name) or self._made.get(name)
        return made.result if made else None

    def out_of_date(self, name: str) -> Optional[tuple[str, ...]]:
        """What has changed since the result of a stage was made: names of parameters and of results that
        it reads, none where it is current. None where there is no result."""
        with self._reading:
            known = {**self._made, **self._given}
            parameters = self._parameters
        return changes(name, _records(known), parameters, self._given)

    def run(self, goals: Sequence[str], job: Optional[Job] = None, strict: bool = False,
            note: Optional[Finding] = None) -> Results:
        """Makes the goals, each with what it needs, and returns all there is then.

        A stage that fails or is stopped where work before it is worth its files ends in a result that
        says so; `strict`: failures are raised. Raises CurveUpsError, and Stopped where there is nothing.
        """
        job = job or Job()
        with self._working:
            with self._reading:
                run = _Run(self.name, self._parameters, dict(self._given), dict(self._made),
                           self.where, job, strict, note)
            try:
                for goal in goals:
                    run.make(goal)
            finally:
                with self._reading:
                    self._made.update(run.lasting)
        return run.results()

    def _checked(self, parameters: Any) -> Any:
        values = native.Parameters(parameters)
        with translated(self.where or "parameters"):
            values.check()
        if not values.get("run_verification"):
            values.set("run_repair", False)
        return values


def _records(made: Mapping[str, Made]) -> Records:
    return {name: one.record for name, one in made.items()}


def _decided(names: Iterable[str], records: Records, parameters: Any) -> Any:
    """The parameters for what reads these results: the project's, but for those that they, and what
    they were made from, decide."""
    return with_values(parameters, settled(names, records))


class _Run:
    """One run: what it made is its own until it ends."""

    def __init__(self, name: str, parameters: Any, given: dict[str, Made], made: dict[str, Made],
                 where: str, job: Job, strict: bool, note: Optional[Finding]):
        self.name, self.parameters, self.given, self.before = name, parameters, given, made
        self.where, self.job, self.strict = where, job, strict
        self.note = note
        self.made: dict[str, Made] = dict(given)
        self.records: dict[str, Record] = dict(_records(given))
        self.lasting: dict[str, Made] = {}  # results that may be asked for again

    def make(self, name: str) -> Made:
        if name in self.made:
            return self.made[name]
        if name not in BY_NAME:
            raise CurveUpsError(f"there is no {name} to start from", self.where, "give a target")
        stage = BY_NAME[name]
        for upstream in stage.reads:
            self.make(upstream)
        key = key_of(stage, self.records, self.parameters)
        known = self.before.get(name)
        made = known if known is not None and not differences(known.record, key) else self._work(stage, key)
        self.made[name] = made
        self.records[name] = made.record
        return made

    def _work(self, stage: Stage, key: Key) -> Made:
        inputs = Inputs(_decided(stage.reads, self.records, self.parameters),
                        {name: self.made[name].result for name in stage.reads}, self.where)
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
        made = Made(result, key, time.perf_counter() - start)
        self.lasting[stage.name] = made
        return made

    def results(self) -> Results:
        """All there is."""
        made = {name: self.made[name] for name in (*self.given, *BY_NAME) if name in self.made}
        stopped = self.job.stopped or any(one.result.stopped for one in made.values())
        return Results(self.name, _decided(made, _records(made), self.parameters), made, self.note, stopped)
