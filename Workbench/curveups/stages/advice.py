# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice: what would help, as findings."""

from __future__ import annotations

from typing import Any, Iterable, Iterator

from ..base.findings import Finding

_GAP = "gap"  # of repair's obstacles: all others are pins'


def suggested(what: Finding) -> Finding:
    """An advice among the reasons of a verdict."""
    return Finding("suggested", what.tiles, {"what_to_do": what})


def against(obstacles: Iterable[str]) -> tuple[Finding, ...]:
    """What would help in general where repair met these; "": contacts that nothing holds stay weak."""
    met = set(obstacles)
    kinds = {"advice.cut_gaps": _GAP in met, "advice.pin_room": bool(met - {_GAP, ""}),
             "advice.pull": "" in met}
    return tuple(Finding(kind) for kind, there in kinds.items() if there)


def of_limits(limits: Any, L: float, H_body: float) -> Iterator[Finding]:
    """On Limits of the sizes of tiles that are set."""
    if limits.was_stopped:
        return
    if limits.L is not None:
        yield Finding.about("limits.L", H_body=H_body, low=limits.L[0], high=limits.L[1])
    elif limits.remeshed:
        yield Finding.about("limits.no_L", H_body=H_body)
    if limits.H_body is not None:
        yield Finding.about("limits.H_body", L=L, H_body=limits.H_body)
    else:
        yield Finding.about("limits.no_H_body", L=L)
    yield Finding("limits.estimated")
