# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts that are given as files."""

from __future__ import annotations

from pathlib import Path


def read_text(path: Path) -> str:
    """The UTF-8 text of a file or pipe, none of a file of size 0: those of the system (/proc/kmsg) are read
    for ever. Raises OSError, and ValueError where it is no text."""
    if path.is_file() and not path.stat().st_size:
        return ""
    return path.read_text(encoding="utf-8-sig")
