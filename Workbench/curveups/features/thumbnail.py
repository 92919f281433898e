# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws a small picture of a surface for file managers: FreeCAD draws one only where it has a window."""

from __future__ import annotations

import struct
import zlib

import numpy as np

SIZE = 128       # pixels, as FreeCAD's own
FINE = 4         # drawn so many times larger, then averaged
LIGHT = np.array([-0.35, -0.45, 0.82])


def thumbnail(V: np.ndarray, F: np.ndarray, colour: tuple[int, int, int]) -> bytes:
    """PNG with a transparent ground. V: N x 3, F: M x 3, seen obliquely from above; colour: sRGB, 0 to
    255."""
    turn, tilt = np.radians(20), np.radians(50)
    right = np.array([np.cos(turn), np.sin(turn), 0])
    up = np.array([-np.sin(turn) * np.cos(tilt), np.cos(turn) * np.cos(tilt), np.sin(tilt)])
    P = V @ np.column_stack([right, up, np.cross(right, up)])
    low, high = P[np.unique(F)].min(0), P[np.unique(F)].max(0)
    scale = 0.92 * SIZE * FINE / max(*(high - low)[:2], 1e-9)
    P = (P - (low + high) / 2) * scale + SIZE * FINE / 2
    corners = P[F]
    normals = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-12)[:, None]
    shade = 0.35 + 0.65 * np.abs(normals @ (LIGHT / np.linalg.norm(LIGHT)))
    image = np.zeros((SIZE * FINE, SIZE * FINE, 4), np.float64)
    for k in np.argsort(corners[:, :, 2].mean(1), kind="stable"):  # from the back to the front
        _fill(image, corners[k, :, :2], np.append(shade[k] * np.array(colour), 255.0))
    image = image.reshape(SIZE, FINE, SIZE, FINE, 4)
    alpha = image[..., 3:].sum(axis=(1, 3))
    colours = image[..., :3].sum(axis=(1, 3)) * 255 / np.maximum(alpha, 1)
    return _png(np.concatenate([colours, alpha / FINE**2], axis=2).round().astype(np.uint8)[::-1])


def _fill(image: np.ndarray, triangle: np.ndarray, value: np.ndarray) -> None:
    low = np.maximum(np.floor(triangle.min(0)).astype(int), 0)
    high = np.minimum(np.ceil(triangle.max(0)).astype(int) + 1, image.shape[0])
    if (high <= low).any():
        return
    x, y = np.meshgrid(np.arange(low[0], high[0]) + 0.5, np.arange(low[1], high[1]) + 0.5)
    sides = []
    for a, b in zip(triangle, np.roll(triangle, -1, axis=0)):
        sides.append((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]))
    inside = (np.min(sides, axis=0) >= 0) | (np.max(sides, axis=0) <= 0)
    image[low[1]:high[1], low[0]:high[0]][inside] = value


def _png(rows: np.ndarray) -> bytes:
    def chunk(kind: bytes, data: bytes) -> bytes:
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    head = struct.pack(">IIBBBBB", rows.shape[1], rows.shape[0], 8, 6, 0, 0, 0)
    data = b"".join(b"\0" + row.tobytes() for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(data, 9))
            + chunk(b"IEND", b""))
