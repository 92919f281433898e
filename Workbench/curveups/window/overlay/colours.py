# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colour maps that stay ordered without red and green, and as grey."""

from __future__ import annotations

import numpy as np

# sRGB at equal steps, linear between them.
_MAPS = {
    "Viridis": ("440154", "472d7b", "3b528b", "2c728e", "21918c", "28ae80", "5ec962", "addc30", "fde725"),
    "Cividis": ("00224e", "123570", "3b496c", "575d6d", "707173", "8a8678", "a59c74", "c3b369", "fee838"),
    "Blue-Orange": ("1b4f8f", "4a7fb5", "86afd3", "c3d8e8", "f2f2ef", "f6d9b5", "eeb170", "d9822f", "a4500a"),
    "Grey": ("202020", "3a3a3a", "555555", "707070", "8c8c8c", "a8a8a8", "c4c4c4", "dfdfdf", "fafafa"),
}
NAMES = tuple(_MAPS)
SIGNED = "Blue-Orange"  # for values of both signs: white is 0
NOTHING = (0.62, 0.62, 0.62)  # no value
PLAIN = (0.91, 0.79, 0.56)    # no field
PIN = (0.71, 0.40, 0.11)
MEMBRANE = (0.35, 0.55, 0.85)
MARK = (0.85, 0.11, 0.38)


def sample(name: str, share: np.ndarray) -> np.ndarray:
    """Colours (sRGB, 0 to 1, ... x 3) of a map at shares from 0 to 1. Shares beyond are clipped; NaN gives
    NOTHING."""
    steps = np.array([[int(text[k : k + 2], 16) for k in (0, 2, 4)] for text in _MAPS[name]]) / 255
    share = np.asarray(share, float)
    known = ~np.isnan(share)
    position = np.clip(np.where(known, share, 0), 0, 1) * (len(steps) - 1)
    rgb = np.stack([np.interp(position, np.arange(len(steps)), steps[:, k]) for k in range(3)], axis=-1)
    return np.where(known[..., None], rgb, NOTHING)


def faded(rgb: np.ndarray) -> np.ndarray:
    """Pale colours in the same order, for what is out of date."""
    return 0.72 + 0.28 * np.asarray(rgb)


def shares(values: np.ndarray, low: float, high: float) -> np.ndarray:
    """Values as shares of a range, infinite ones at its ends; 0 or 1 in a range without width."""
    values = np.asarray(values, float)
    if high > low:
        with np.errstate(invalid="ignore"):
            return (values - low) / (high - low)
    return np.where(np.isnan(values), np.nan, (values > low).astype(float))


def packed(rgb: np.ndarray, alpha: float = 1.0) -> np.ndarray:
    """Colours (0 to 1, ... x 3) as Coin packs them: 0xRRGGBBAA."""
    bytes_ = np.rint(np.clip(rgb, 0, 1) * 255).astype(np.uint32)
    return (bytes_[..., 0] << 24 | bytes_[..., 1] << 16 | bytes_[..., 2] << 8 | np.uint32(round(255 * alpha)))
