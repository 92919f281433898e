# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads profiles and materials: named sets of parameters, in files as `--config` takes them. A profile suits
a kind of printer. A material gives the "sources" of its numbers by quantity: `low`, `high`, `source`, `date`
and `assumed` (no source was read). A quantity without a side stands for both sides' parameters."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Iterable

from .errors import CurveUpsError
from .native import native

_RESOURCES = Path(__file__).parents[3] / "resources"
NOTES = ("about", "kind", "sources")  # keys that are no parameters
MATERIALS = ("material_membrane", "material_glue", "material_tile")  # kinds; `--set KIND=NAME` chooses one


def profile_names() -> list[str]:
    """Names of the profiles in alphabetical order."""
    return sorted(path.stem for path in (_RESOURCES / "profiles").glob("*.json"))


def profile_path(name: str) -> Path:
    """File of a profile."""
    return _RESOURCES / "profiles" / f"{name}.json"


def material_names(kind: str) -> list[str]:
    """Names of the materials of a kind (MATERIALS) in alphabetical order."""
    return sorted(path.stem for path in (_RESOURCES / "materials").glob("*.json")
                  if _read(path)["kind"] == kind)


def material_path(name: str) -> Path:
    return _RESOURCES / "materials" / f"{name}.json"


def about(path: Path) -> str:
    """Note on a profile or material."""
    return str(_read(path).get("about", ""))


def parameters(path: Path) -> dict[str, Any]:
    """Values by parameter."""
    return {key: value for key, value in _read(path).items() if key not in NOTES}


def defaults(paths: Iterable[Path]) -> dict[str, Any]:
    """Defaults of all parameters that some of these files set."""
    common = native.Parameters()
    return {key: common.get(key) for path in paths for key in parameters(path)}


def of_material(kind: str, name: Any, where: str) -> dict[str, Any]:
    """Parameters of a material. Raises CurveUpsError for an unknown name."""
    known = material_names(kind)
    if name not in known:
        raise CurveUpsError(f"there is no {kind} '{name}'", where, f"give one of {', '.join(known)}")
    return parameters(material_path(str(name)))


def _read(path: Path) -> dict[str, Any]:
    return dict(json.loads(path.read_text(encoding="utf-8")))
