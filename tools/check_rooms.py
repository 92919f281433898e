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
    "refinement": ("layout", "physics"), "bindings": ("refinement", "fabrication"),
}
# Headers of libraries, and the only rooms that may see them.
LIBRARIES = (
    ("OpenCASCADE", r"[\w/]+\.hxx", {"fabrication"}),
    ("lib3mf", r"(Model/COM/|lib3mf).*", {"fabrication"}),
    ("Clipper", r"polyclipping/.*", {"bodies"}),
    ("CHOLMOD", r"cholmod.*|suitesparse/.*", {"numerics"}),
    ("oneTBB", r"(tbb|oneapi)/.*", {"core"}),
    ("Ceres", r"ceres/.*", {"layout"}),
    ("CGAL", r"CGAL/.*", {"geometry"}),
    ("pybind11", r"pybind11/.*", {"bindings"}),
)

# Python: the first name that fits a module's path below Workbench/curveups gives its layer.
LAYERS = (
    ("qt", r"qt\.py"), ("commands", r"(commands|panels|overlay)/.*"), ("viewproviders", r"viewproviders/.*"),
    ("features", r"features/.*"), ("cli", r"cli(\.py|_commands\.py|/.*)"), ("report", r"report/.*"),
    ("project", r"project\.py"), ("stages", r"stages/.*"),
)
FORBIDDEN: dict[str, tuple[str, ...]] = {  # what a layer must not import
    "stages": ("project", "cli", "features", "commands", "viewproviders", "qt"),
    "project": ("cli", "features", "commands", "viewproviders", "qt"),
    "report": ("cli", "features", "commands", "viewproviders", "qt"),
    "features": ("cli", "commands", "qt"),
    "cli": ("commands", "qt"),
}
GUI = {"FreeCADGui": ("viewproviders", "commands", "qt"), "PySide": ("qt",), "PySide2": ("qt",),
       "PySide6": ("qt",), "pivy": ("commands", "viewproviders")}


def below(room: str) -> set[str]:
    """All rooms that a room may include, itself too."""
    return {room}.union(*(below(other) for other in NATIVE[room]))


def wrong_includes() -> Iterator[str]:
    folder = ROOT / "native" / "curveups"
    for path in sorted((*folder.rglob("*.hpp"), *folder.rglob("*.cpp"))):
        room = path.relative_to(folder).parts[0]
        where = path.relative_to(ROOT)
        if room not in NATIVE:
            yield f"{where}: the room {room} is not known"
            continue
        for name in re.findall(r'^\s*#include [<"]([^>"]+)[>"]', path.read_text(encoding="utf-8"), re.M):
            if name.startswith("curveups/") and name.split("/")[1] not in below(room):
                yield f"{where}: {room} must not include {name}"
            for library, pattern, rooms in LIBRARIES:
                if re.fullmatch(pattern, name) and room not in rooms:
                    yield f"{where}: {library} ({name}) belongs to {', '.join(sorted(rooms))}"


def layer_of(path: str) -> str:
    return next((layer for layer, pattern in LAYERS if re.fullmatch(pattern, path)), "")


def imported(path: Path, package: Path) -> Iterator[str]:
    """Full names of all that a file imports, inside functions too; ours as paths below the package."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            parts = list(path.relative_to(package.parent).parts[:-node.level]) if node.level else []
            base = ".".join([*parts, *([node.module] if node.module else [])])
            yield base
            yield from (f"{base}.{alias.name}" for alias in node.names)


def wrong_imports() -> Iterator[str]:
    package = ROOT / "Workbench" / "curveups"
    for path in sorted(package.rglob("*.py")):
        inside = path.relative_to(package).as_posix()
        layer, where = layer_of(inside), path.relative_to(ROOT)
        for name in dict.fromkeys(imported(path, package)):
            top, *rest = name.split(".")
            if top in GUI and layer not in GUI[top]:
                yield f"{where}: {top} belongs to {', '.join(GUI[top])}"
            if top != package.name or not rest:
                continue
            target = "/".join(rest)
            other = layer_of(f"{target}.py") or layer_of(f"{target}/")
            if other in FORBIDDEN.get(layer, ()):
                yield f"{where}: {layer} must not import {name}"


def main() -> int:
    found = [*wrong_includes(), *wrong_imports()]
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
