# SPDX-License-Identifier: LGPL-2.1-or-later
"""What results consist of."""

from __future__ import annotations

from typing import ClassVar


class Value:
    """Base of frozen dataclasses that can be saved: they are known by their name to whoever saves them."""

    known: ClassVar[dict[str, type]] = {}

    def __init_subclass__(cls) -> None:
        Value.known[cls.__name__] = cls
