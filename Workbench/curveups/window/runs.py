# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a design from the window, for Check, Solve, Verify, Repair, Build Solids, and for the
tiles that Cuts needs."""

from __future__ import annotations

from contextlib import suppress
from functools import partial
from typing import Any, Callable, Optional

from ..base.errors import CurveUpsError
from ..base.native import native, problem
from ..features import actions
from ..features.document import has_layout
from ..stages.stage import Job
from .macro import call, named
from .overlay.fields import measured
from .qt import translate
from .run import LIVE, Task


def reason(which: str, design: Any) -> str:
    """Why a run of a design can't start now; empty where it can."""
    wrong = problem()
    if wrong is not None:
        return str(wrong)
    if LIVE.busy:
        return LIVE.obstacle()
    of_target = which in actions.RUNS and actions.RUNS[which].of_target  # exports are of a layout
    if not of_target and not has_layout(design):
        return translate("CurveUps", "There is no layout yet: Solve makes it")
    return ""


def start(which: str, design: Any, told: Optional[Callable[[], None]] = None) -> None:
    """Starts a run on the worker; its results become the document's when it ends, and `told` is called
    then. Raises CurveUpsError where it can't start."""
    wrong = reason(which, design)
    if wrong:
        raise CurveUpsError(wrong)
    title = translate("CurveUps_" + _camel(which), actions.RUNS[which].title)
    project, work = actions.prepare(which, design)
    LIVE.start(design, Task(title, _measuring(work), partial(finish, which), project, told, _recompute))


def finish(which: str, design: Any, made: Any, *arguments: str) -> None:
    """Hands what a thread has made to the function `which` of `actions`, and calls that as a macro does.
    arguments: as Python text."""
    actions.hand_over(which, design, made)
    call(f"actions.{which}", named(design), *arguments)


def _measuring(work: actions.Work) -> actions.Work:
    """Work that measures the design it has made, for its picture."""
    def run(job: Job) -> actions.Ran:
        ran = work(job)
        if "design" in ran.results:
            with suppress(native.Error):  # whoever draws it says so
                measured(ran.results.design.with_parameters(ran.results.parameters))
        return ran

    return run


def _recompute(design: Any) -> None:
    with design.Proxy.many_changes():
        design.Document.recompute()
    design.Proxy.refresh(design)


def _camel(which: str) -> str:
    return "".join(word.capitalize() for word in which.split("_"))
