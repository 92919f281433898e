# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads profiles: named sets of parameters that suit a kind of printer, in files as `--config` takes them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from .native import native

_FOLDER = Path(__file__).parents[3] / "resources" / "profiles"
ABOUT = "about"  # the key of a note of the file's author


def profile_names() -> list[str]:
    """In alphabetical order."""
    return sorted(path.stem for path in _FOLDER.glob("*.json"))


def profile_path(name: str) -> Path:
    """The file of one of these."""
    return _FOLDER / f"{name}.json"


def about(name: str) -> str:
    """What is to be known of a profile."""
    return str(_read(name).get(ABOUT, ""))


def parameters(name: str) -> dict[str, Any]:
    """Values by parameter; of "" the defaults of all that some profile sets."""
    if name:
        return {key: value for key, value in _read(name).items() if key != ABOUT}
    defaults = native.Parameters()
    return {key: defaults.get(key) for profile in profile_names() for key in parameters(profile)}


def _read(name: str) -> dict[str, Any]:
    return dict(json.loads(profile_path(name).read_text(encoding="utf-8")))
