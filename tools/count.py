# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts what should not grow: lines of product code by room, modules in the largest ring, loose modules,
imports of our own inside of functions. tools/check prints it."""

from __future__ import annotations

from pathlib import Path
from typing import Iterable

import check_rooms


def lines(paths: Iterable[Path]) -> int:
    return sum(path.read_text(encoding="utf-8").count("\n") for path in paths)


def main() -> None:
    native, package = check_rooms.ROOT / "native" / "curveups", check_rooms.ROOT / "Workbench" / "curveups"
    rooms = {f"native {room.name}": lines((*room.rglob("*.hpp"), *room.rglob("*.cpp")))
             for room in sorted(native.iterdir())}
    rooms |= {f"Python {room.name}": lines(room.rglob("*.py"))
              for room in sorted(package.iterdir()) if room.is_dir() and room.name.isidentifier()}
    known = check_rooms.modules(package)
    names = {module: list(check_rooms.imported(path, package)) for module, path in known.items()}
    graph = {module: [name for name, _ in found if name in known and name != module]
             for module, found in names.items()}
    late = sum(late and name in known for found in names.values() for name, late in found)
    for room, count in rooms.items():
        print(f"{room:<24}{count:>7}")
    print(f"{'lines of product code':<24}{lines((*native.rglob('*.?pp'), *package.parent.rglob('*.py'))):>7}")
    print(f"{'largest ring':<24}{max(map(len, check_rooms.rings(graph)), default=1):>7}")
    print(f"{'loose modules':<24}{sum(path.parent == package for path in known.values()):>7}")
    print(f"{'late imports':<24}{late:>7}")


if __name__ == "__main__":
    main()
