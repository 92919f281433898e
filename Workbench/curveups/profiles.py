# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sets of parameters that suit a kind of printer, by name: files as `--config` takes them."""

from __future__ import annotations

from pathlib import Path

_FOLDER = Path(__file__).parents[2] / "resources" / "profiles"


def profile_names() -> list[str]:
    """In alphabetical order."""
    return sorted(path.stem for path in _FOLDER.glob("*.json"))


def profile_path(name: str) -> Path:
    """The file of one of these."""
    return _FOLDER / f"{name}.json"
