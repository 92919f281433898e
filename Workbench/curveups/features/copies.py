# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gives a copy of a Design its own objects where it was copied without them."""

from __future__ import annotations

from typing import Any

from .proxy import SLOTS, type_of


def own_parts(obj: Any) -> None:
    """Copies the parts that another Design has as well."""
    for slot in SLOTS:
        part = getattr(obj, slot)
        if part is not None and any(other != obj and type_of(other) == type_of(obj) for other in part.InList):
            setattr(obj, slot, obj.Document.copyObject(part, False))
