# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sorts the findings of native checks: errors are raised, the rest become warnings."""

from __future__ import annotations

from typing import Any, Callable, Iterable

from ..base.errors import CurveUpsError, tile_list

Place = Callable[[Any], tuple[str, list[int]]]  # of a finding: words for a message, tiles for a report


def faces_place(finding: Any) -> tuple[str, list[int]]:
    """Faces of the input, which are not the tiles to come, by their number from 1."""
    rows = [int(row) for row in finding.faces]
    if not rows:
        return "", []
    shown = ", ".join(str(row + 1) for row in rows[:6])
    return f"faces {shown}" + (f" and {len(rows) - 6} more" if len(rows) > 6 else ""), []


def tiles_place(finding: Any) -> tuple[str, list[int]]:
    """Tiles by their names."""
    rows = [int(row) for row in finding.tiles]
    return tile_list(rows), rows


def settle(findings: Iterable[Any], where: str, place: Place) -> tuple[dict, ...]:
    """Raises the first error among findings; all others as warnings of a report."""
    warnings = []
    for finding in findings:
        words, tiles = place(finding)
        if finding.is_error:
            raise CurveUpsError(finding.message, ", ".join(part for part in (where, words) if part),
                                finding.remedy)
        warnings.append({"what": finding.message, "kind": finding.kind, "remedy": finding.remedy,
                         "tiles": tiles})
    return tuple(warnings)
