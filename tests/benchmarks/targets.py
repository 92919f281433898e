# SPDX-License-Identifier: LGPL-2.1-or-later
"""Built-in targets and meshes of a folder, and the designs that benchmarks make of them."""

from __future__ import annotations

import argparse
import resource
import sys
from pathlib import Path
from typing import Any, Iterator

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "Workbench"), str(ROOT / "tools")]

from curveups.base.native import native  # noqa: E402
from curveups.project.project import Project  # noqa: E402
from curveups.stages import stages_of  # noqa: E402
from curveups.stages.cut_request import CutRequest  # noqa: E402
from curveups.stages.surface import find_source  # noqa: E402


def chosen(parser: argparse.ArgumentParser) -> Iterator[tuple[str, str]]:
    """Names and targets, by --only and --models. A mesh called as a built-in target is "NAME (mesh)"."""
    parser.add_argument("--only", metavar="NAME,...")
    parser.add_argument("--models", type=Path, metavar="DIR", help="meshes to be taken as they are, besides")
    options = parser.parse_args()
    targets = {name: name for name, _ in native.builtin_targets()}
    for path in sorted(options.models.glob("*.obj")) if options.models else ():
        targets[f"{path.stem} (mesh)" if path.stem in targets else path.stem] = str(path)
    names = options.only.split(",") if options.only else list(targets)
    if unknown := [name for name in names if name not in targets]:
        parser.error(f"unknown model {unknown[0]}: there are {', '.join(targets)}")
    for name in names:
        yield name, targets[name]


def solved(target: str, **values: Any) -> Project:
    """The design of a target with these parameters."""
    parameters = native.Parameters()
    for name, value in values.items():
        parameters.set(name, value)
    name = Path(target).stem
    source = find_source(target, remesh=name == target, will_be_cut=False)
    project = Project(name, parameters, {"source": source, "cut request": CutRequest()}, target)
    project.run(stages_of("solve"))
    return project


def used() -> float:
    """Seconds of processor of this process and all its threads."""
    now = resource.getrusage(resource.RUSAGE_SELF)
    return now.ru_utime + now.ru_stime
