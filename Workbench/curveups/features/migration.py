# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of older versions, brought into the shape of today's."""

from __future__ import annotations

from typing import Any


def migrate(document: Any) -> list[Any]:
    """The objects that were changed."""
    return []
