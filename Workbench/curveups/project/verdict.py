# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decides whether a design is valid. What a design must keep is judged by the native module alone:
a design is valid that was verified and against which no result gives a reason."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Optional

from ..base.findings import Finding, unique
from ..stages import BY_NAME, SETTLED, VERDICT

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
