# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the tables of a page and formats their numbers."""

from __future__ import annotations

from html import escape
from typing import Any, Sequence


def table(rows: Sequence[tuple[Any, ...]], head: tuple[str, ...] = ()) -> str:
    """Rows of texts and numbers."""
    top = "<tr>" + "".join(f"<th>{escape(cell)}</th>" for cell in head) + "</tr>" if head else ""
    lines = []
    for row in rows:
        cells = "".join(f"<td>{escape(show(cell))}</td>" for cell in row)
        lines.append(f"<tr>{cells}</tr>")
    kind = "" if len(head) > 2 else ' class="pairs"'
    return f"<table{kind}>{top}{''.join(lines)}</table>"


def show(value: Any) -> str:
    """A value in few digits."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.4g}" if abs(value) < 1e5 else f"{value:.0f}"
    if isinstance(value, (list, tuple)):
        return ", ".join(show(item) for item in value)
    return str(value)
