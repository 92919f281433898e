# SPDX-License-Identifier: LGPL-2.1-or-later
"""Defines the Verification object: forces of contacts and tiles as lists."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from .figures import add_figures
from .proxy import OUTPUT, READ_ONLY, PartProxy, add

# Property, array of the verification, type, tooltip.
_LISTS = (
    ("ContactTiles", "contact_tiles", "App::PropertyIntegerList",
     "The two tiles of each contact, counted from 0."),
    ("ContactNormalMin", "contact_normal_min", "App::PropertyFloatList",
     "Least normal force at a contact's points, N."),
    ("ContactNormalMean", "contact_normal_mean", "App::PropertyFloatList",
     "Mean normal force at a contact's points, N."),
    ("ContactFriction", "contact_friction_ratio", "App::PropertyFloatList",
     "Friction over normal force that a contact needs."),
    ("TileNormalForce", "tile_normal_force", "App::PropertyFloatList",
     "Least normal force at a tile's contact points, N."),
)


class VerificationProxy(PartProxy):
    """Behaviour of a Verification."""

    TYPE = "CurveUps::Verification"

    def add_properties(self, obj: Any) -> None:
        super().add_properties(obj)
        for name, _, kind, tip in _LISTS:
            add(obj, kind, name, "Verification", tip, READ_ONLY | OUTPUT)
        add_figures(obj, with_units=True)
        add(obj, "App::PropertyIntegerList", "WeakContacts", "Verification",
            "Pairs of tiles whose contact is below the least force, counted from 0.", READ_ONLY | OUTPUT)


def write_verification(obj: Any, found: Optional[Any]) -> None:
    """`found`: the stage's result; nothing where there is none."""
    arrays = found.arrays if found is not None else {}
    for name, array, _, _ in _LISTS:
        setattr(obj, name, np.ravel(arrays.get(array, ())).tolist())
    obj.WeakContacts = [v for pair in (found.weak_contacts if found is not None else ()) for v in pair]
