# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of the rooms: which folder may include or import which, and which library belongs to whom.

Static libraries catch most wrong includes by not linking; headers alone, the module and Python do not.
Called by tools/check."""

from __future__ import annotations

import ast
import re
import sys
from pathlib import Path
from typing import Iterator

ROOT = Path(__file__).resolve().parents[1]

# What each native room may include directly; what those may include is included.
NATIVE: dict[str, tuple[str, ...]] = {
    "core": (), "numerics": ("core",), "geometry": ("numerics",), "design": ("geometry",),
    "bodies": ("design",), "layout": ("design",), "physics": ("bodies",), "fabrication": ("bodies",),
    "contact": ("physics",), "actuation": ("contact",), "refinement": ("layout", "physics"),
    "bindings": ("actuation", "refinement", "fabrication"),
}
# Headers of libraries, and the only rooms that may see them.
LIBRARIES = (
    ("OpenCASCADE", r"[\w/]+\.hxx", set[str]()),
    ("zlib", r"zlib\.h", {"fabrication"}),
    ("Clipper", r"polyclipping/.*", {"bodies"}),
    ("CHOLMOD", r"cholmod.*|suitesparse/.*", {"numerics"}),
    ("oneTBB", r"(tbb|oneapi)/.*", {"core"}),
    ("CGAL", r"CGAL/.*", {"geometry"}),
    ("pybind11", r"pybind11/.*", {"bindings"}),
)

# The same for the rooms of Python.
PYTHON: dict[str, tuple[str, ...]] = {
    "base": (), "targets": ("base",), "stages": ("targets",), "project": ("stages",),
    "report": ("project",), "kit": ("report",), "features": ("kit",), "cli": ("features",),
    "window": ("features",),
}
LOOSE = {"__init__.py"}  # modules of no room
# Only what FreeCAD's start, or that of a command that fails, would pay for is imported inside functions.
LATE = {"features/observer.py", "cli/__init__.py"}
# Where modules of the window may be imported: a room, or one file.
GUI = {"FreeCADGui": "window/", "pivy": "window/", "PySide": "window/qt.py", "PySide2": "window/qt.py",
       "PySide6": "window/qt.py"}


def below(room: str, rooms: dict[str, tuple[str, ...]]) -> set[str]:
    """All rooms that a room may include, itself too."""
    return {room}.union(*(below(other, rooms) for other in rooms[room]))


def wrong_includes() -> Iterator[str]:
    folder = ROOT / "native" / "curveups"
    for path in sorted((*folder.rglob("*.hpp"), *folder.rglob("*.cpp"))):
        room = path.relative_to(folder).parts[0]
        where = path.relative_to(ROOT)
        if room not in NATIVE:
            yield f"{where}: the room {room} is not known"
            continue
        for name in re.findall(r'^\s*#include [<"]([^>"]+)[>"]', path.read_text(encoding="utf-8"), re.M):
            if name.startswith("curveups/") and name.split("/")[1] not in below(room, NATIVE):
                yield f"{where}: {room} must not include {name}"
            for library, pattern, rooms in LIBRARIES:
                if re.fullmatch(pattern, name) and room not in rooms:
                    yield f"{where}: {library} ({name}) belongs to {', '.join(sorted(rooms)) or 'no room'}"


def imported(path: Path, package: Path) -> Iterator[tuple[str, bool]]:
    """Full names of all that a file imports, and whether it does so inside of a function; ours begin with the
    package's name."""
    def walk(node: ast.AST, late: bool) -> Iterator[tuple[ast.AST, bool]]:
        for child in ast.iter_child_nodes(node):
            inside = late or isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef))
            yield child, inside
            yield from walk(child, inside)

    for node, late in walk(ast.parse(path.read_text(encoding="utf-8")), False):
        if isinstance(node, ast.Import):
            yield from ((alias.name, late) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            parts = list(path.relative_to(package.parent).parts[:-node.level]) if node.level else []
            base = ".".join([*parts, *([node.module] if node.module else [])])
            for alias in node.names:
                name = f"{base}.{alias.name}"
                found = package.parent / name.replace(".", "/")
                module = base == package.name or found.is_dir() or found.with_suffix(".py").is_file()
                yield (name if module else base), late


def modules(package: Path) -> dict[str, Path]:
    """All modules of ours by their full names."""
    found = {}
    for path in sorted(package.rglob("*.py")):
        parts = path.relative_to(package.parent).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def wrong_imports() -> Iterator[str]:
    package = ROOT / "Workbench" / "curveups"
    known = modules(package)
    graph: dict[str, list[str]] = {}
    for module, path in known.items():
        inside, where = path.relative_to(package).as_posix(), path.relative_to(ROOT)
        room = inside.split("/")[0]
        if "/" not in inside and inside not in LOOSE or "/" in inside and room not in PYTHON:
            yield f"{where}: the room {room} is not known"
            continue
        names = dict.fromkeys(imported(path, package))
        graph[module] = [name for name, _ in names if name in known and name != module]
        for name, late in names:
            top, *rest = name.split(".")
            if top in GUI and not inside.startswith(GUI[top]):
                yield f"{where}: {top} belongs to {GUI[top]}"
            if top != package.name or not rest:
                continue
            if rest[0] in PYTHON and room in PYTHON and rest[0] not in below(room, PYTHON):
                yield f"{where}: {room} must not import {name}"
            if late and inside not in LATE:
                yield f"{where}: {name} is imported inside of a function"
    for ring in rings(graph):
        yield f"these modules import one another: {', '.join(ring)}"


def rings(graph: dict[str, list[str]]) -> list[list[str]]:
    """Modules that reach one another by their imports, each ring sorted."""
    reached = {start: reach(graph, start) for start in graph}
    found = {tuple(sorted({start} | {other for other in reached[start] if start in reached[other]}))
             for start in graph if start in reached[start]}
    return [list(ring) for ring in sorted(found)]


def reach(graph: dict[str, list[str]], start: str) -> set[str]:
    """All modules that one imports, and what these import."""
    found: set[str] = set()
    pending = list(graph[start])
    while pending:
        name = pending.pop()
        if name not in found:
            found.add(name)
            pending += graph.get(name, ())
    return found


def main() -> int:
    found = [*wrong_includes(), *wrong_imports()]
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
