# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a print costs: the printer's prices, or the user's."""

from __future__ import annotations

import math
from typing import Any, Mapping

from ..base.errors import CurveUpsError


def chosen_prices(text: str, prices: Mapping[str, Any]) -> dict[str, Any]:
    """The printer's prices, with those of `text` in their place: "hour=3, currency=USD". Raises
    CurveUpsError."""
    found = dict(prices)
    for part in filter(None, (one.strip() for one in text.split(","))):
        name, _, value = (one.strip() for one in part.partition("="))
        if name not in prices:
            raise CurveUpsError(f"'{part}' is no price", "", f"give some of {', '.join(prices)}, as hour=2.5")
        if name == "currency" and not value:
            raise CurveUpsError("the currency has no name", "", "give it one, as currency=USD")
        found[name] = value if name == "currency" else _number(name, value)
    return found


def price(hours: float, rigid: float, soft: float, prices: Mapping[str, Any]) -> float:
    """Of an order of so many hours, cm3 of rigid and of soluble material."""
    return float(prices["order"] + hours * prices["hour"] + rigid * prices["rigid_cm3"]
                 + soft * prices["support_cm3"])


def _number(name: str, value: str) -> float:
    try:
        found = float(value)
    except ValueError:
        found = math.nan
    if not 0 <= found < 1e9:
        raise CurveUpsError(f"the price {name} is '{value}'", "", "give a number, 0 or more, as hour=2.5")
    return found
