# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one exception that reaches the user, and the exit statuses of the command line."""

from __future__ import annotations

from typing import Any, Iterable

VALID, NOT_VALID, BAD_INPUT, STOPPED, NOT_WRITTEN = range(5)


class CurveUpsError(Exception):
    """An error in one line, `WHAT (WHERE): REMEDY`. tiles: rows of F that it names. finding: the Finding
    behind it; or None."""

    def __init__(self, what: str, where: str = "", remedy: str = "", status: int = BAD_INPUT,
                 tiles: Iterable[int] = (), finding: Any = None):
        self.what, self.where, self.remedy, self.status = what, where, remedy, status
        self.finding = finding
        self.tiles = tuple(tiles) if finding is None else finding.tiles
        super().__init__(str(self))

    def __str__(self) -> str:
        line = self.what + (f" ({self.where})" if self.where else "")
        line += f": {self.remedy}" if self.remedy else ""
        return " ".join(line.split())


# Python packages of reports, pictures and the kit's drawings, which some of FreeCAD's builds lack.
PACKAGES = {"ezdxf", "jinja2", "markupsafe", "matplotlib", "PIL", "scipy"}


def without_package(error: Exception) -> Exception:
    """Return the user's error where a package is missing; else the error."""
    name = (error.name or "").split(".")[0] if isinstance(error, ModuleNotFoundError) else ""
    if name not in PACKAGES:
        return error
    return CurveUpsError(f"this needs the Python package {name}, which this FreeCAD lacks", "",
                         "install it with pip into FreeCAD's Python; designs, solids, STEP, STL and 3MF do "
                         "without")


class Stopped(Exception):
    """The user stopped the work where no partial result exists."""


def tile_name(row: int) -> str:
    """Name of row `row` of F in files and messages."""
    return f"T{row + 1:05d}"


def named_tiles(text: str, count: int, option: str) -> list[int]:
    """Rows of F, of which there are `count`, by their names, "T00012,T00345". Raises CurveUpsError."""
    rows = {tile_name(row): row for row in range(count)}
    names = [name.strip() for name in text.split(",")]
    for name in names:
        if name not in rows:
            raise CurveUpsError(f"'{name}' is no tile", option,
                                f"give some of {tile_name(0)} to {tile_name(count - 1)}")
    return [rows[name] for name in names]


def tile_list(rows: Iterable[int], most: int = 6) -> str:
    """Names of up to `most` tiles for a message."""
    rows = list(rows)
    names = ", ".join(tile_name(int(row)) for row in rows[:most])
    return names + (f" and {len(rows) - most} more" if len(rows) > most else "")
