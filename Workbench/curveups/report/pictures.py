# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a design, drawn by matplotlib without a display: flat layout, actuated view, cuts, membranes.

The same design gives the same bytes: no dates, no random ids, fixed sizes.
"""

from __future__ import annotations

import io
from types import SimpleNamespace
from typing import Any, Sequence

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PathCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.path import Path
from PIL import Image

from ..stages.cut_request import sides_of_edges

matplotlib.rcParams["svg.hashsalt"] = "curveups"  # the same ids every time
matplotlib.rcParams["font.size"] = 9

BODY, PIN, EDGE, WEAK = "#e9c98f", "#b5651d", "#7a5a2b", "#d81b60"
MARKS = ("#cfc8bb", "#ef8a17", "#c62828")  # of tiles: sound, doubtful, impossible


def inset_triangles(corners: np.ndarray, q: np.ndarray) -> np.ndarray:
    """M x 3 x 2 triangles whose edges lie q (M x 3) inside those of `corners`."""
    edge = np.roll(corners, -1, axis=1) - corners
    double_area = edge[:, :1, 0] * edge[:, 1:2, 1] - edge[:, :1, 1] * edge[:, 1:2, 0]
    share = (q * np.linalg.norm(edge, axis=2) / double_area)[..., None]  # of the height over each edge
    # Corner t lies on the moved edges t - 1 and t.
    return corners + np.roll(share, 1, axis=1) * edge + share * (np.roll(corners, 1, axis=1) - corners)


def flat_layout(design: Any, values: np.ndarray | None = None, label: str = "",
                marked: Sequence[tuple[int, int]] = (), width: float = 9.0) -> bytes:
    """Tiles with their front pins, to scale; `values` colours the tiles, `marked` pairs of tiles are
    joined by a line."""
    share = 0.92 if values is None else 0.8  # of the width; the rest is for the colours' scale
    below = 0.5  # inches, for the axis
    height = _height(design.T, share * width, 3, 14) + below + 0.1
    figure = Figure(figsize=(width, height))
    axes = figure.add_axes([0.06, below / height, share, 1 - (below + 0.1) / height])
    tiles = _draw_flat(axes, design, values)
    if values is not None:
        figure.colorbar(tiles, cax=figure.add_axes([0.9, 0.2, 0.02, 0.6]), label=label)
    if len(marked):
        centres = np.asarray(design.T).mean(1)
        axes.add_collection(LineCollection([centres[list(pair)] for pair in marked], colors=WEAK,
                                           linewidths=2))
    _label(axes)
    return _png(figure, scale=values is not None)


def actuated_view(design: Any, width: float = 7.0) -> bytes:
    """The tiles in the target shape, lit, seen from the front's side at an angle."""
    figure = Figure(figsize=(width, _height(_seen(design)[0], width, 2.5, 9)))
    _draw_actuated(figure.add_axes([0, 0, 1, 1]), design)
    return _png(figure)


def blocked_view(V: np.ndarray, F: np.ndarray, marks: np.ndarray) -> bytes:
    """A target from two sides, its tiles in the colours of their marks: 0, 1 (doubtful), 2 (impossible)."""
    colours = np.array([matplotlib.colors.to_rgb(mark) for mark in MARKS])[marks]
    return _png(two_sides(V, F, colours)[0])


def distance_view(V: np.ndarray, F: np.ndarray, values: np.ndarray, most: float | None = None) -> bytes:
    """Tiles from two sides, coloured by their values (M, mm) on a scale from 0 to `most`, or the largest."""
    most = float(np.max(values)) if most is None else most
    scale = matplotlib.cm.ScalarMappable(Normalize(0, max(most, 1e-9)), "viridis")
    figure, height = two_sides(V, F, scale.to_rgba(values)[:, :3], 0.6)
    figure.colorbar(scale, cax=figure.add_axes([0.3, 0.4 / height, 0.4, 0.12 / height]),
                    orientation="horizontal", label="mm")
    return _png(figure, scale=True)


def two_sides(V: np.ndarray, F: np.ndarray, colours: np.ndarray, below: float = 0.0,
              width: float = 10.0) -> tuple[Figure, float]:
    """A picture of the tiles in these colours (M x 3) and its height, inches, of which `below` are free."""
    target = SimpleNamespace(V=V, F=F)
    height = _height(_seen(target)[0], 0.5 * width, 2.5, 9) + below
    figure = Figure(figsize=(width, height))
    for place, turned in ((0.0, False), (0.5, True)):
        _draw_actuated(figure.add_axes([place, below / height, 0.5, 1 - below / height]), target, turned,
                       colours)
    return figure, height


def _draw_flat(axes: Any, design: Any, values: np.ndarray | None) -> PolyCollection:
    T, q = np.asarray(design.T), np.asarray(design.q)
    thin = float(np.clip(120 / np.sqrt(len(T)) / 10, 0.15, 0.8))
    tiles = PolyCollection(T, edgecolors=EDGE, linewidths=thin)
    if values is None:
        tiles.set_facecolor(BODY)
    else:
        tiles.set_array(values)
        tiles.set_cmap("viridis")
    axes.add_collection(tiles)
    axes.add_collection(PolyCollection(inset_triangles(T, q[:, 0]), facecolors=PIN,
                                       edgecolors="none", alpha=0.85 if values is None else 0.25))
    _frame(axes, *_bounds(T))
    return tiles


def _draw_actuated(axes: Any, design: Any, turned: bool = False, colours: np.ndarray | None = None,
                   lines: Sequence[tuple[int, int, str]] = ()) -> None:
    """lines: tile, edge and colour of edges to be drawn where no tile hides them."""
    corners, normal = _seen(design, turned)
    light = np.array([-0.35, 0.5, 0.8])
    shade = 0.3 + 0.7 * np.abs(normal @ light) / np.linalg.norm(light)
    if colours is None:
        colours = np.where(normal[:, 2:] > 0, matplotlib.colors.to_rgb("#f0b24a"),
                           matplotlib.colors.to_rgb("#8fa7bf"))
    colour = colours * shade[:, None]
    rims = np.array([edge for *edge, _ in lines], int).reshape(-1, 2)
    ends = np.stack([corners[rims[:, 0], rims[:, 1]], corners[rims[:, 0], (rims[:, 1] + 1) % 3]], axis=1)
    drawn = [*corners[:, :, :2], *ends[:, :, :2]]
    faces = [*map(tuple, colour.clip(0, 1)), *("none" for _ in lines)]
    edges = [*("#5b4420" for _ in corners), *(paint for *_, paint in lines)]
    depth = corners[:, :, 2].mean(1)
    depth = np.concatenate([depth, np.maximum(depth[rims[:, 0]], ends[:, :, 2].mean(1))])
    order = np.argsort(depth, kind="stable")  # painter: far ones first
    axes.add_collection(PolyCollection(
        [drawn[k] for k in order], facecolors=[faces[k] for k in order], edgecolors=[edges[k] for k in order],
        linewidths=np.where(order < len(corners), 0.25, 2.0), closed=False))
    _frame(axes, *_bounds(corners))
    axes.axis("off")


def _seen(design: Any, turned: bool = False) -> tuple[np.ndarray, np.ndarray]:
    """Corners (M x 3 x 3) and normals of the actuated tiles in the camera's coordinates; `turned`:
    from the opposite side."""
    V, F = np.asarray(design.V), np.asarray(design.F)
    points = (V - V.mean(0)) @ camera(V, F).T
    corners = (points * np.array([-1.0, 1.0, -1.0]) if turned else points)[F]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return corners, normal / np.linalg.norm(normal, axis=1, keepdims=True)


def _bounds(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    points = corners[..., :2].reshape(-1, 2)
    return points.min(0), points.max(0)


def _height(corners: np.ndarray, width: float, least: float, most: float) -> float:
    """Height of a picture of this width, both in inches, that shows these corners to scale."""
    low, high = _bounds(np.asarray(corners))
    return float(np.clip(width * (high[1] - low[1]) / (high[0] - low[0]), least, most))


def _label(axes: Any) -> None:
    axes.set_xlabel("mm")
    axes.spines[["top", "right"]].set_visible(False)


def _frame(axes: Any, low: np.ndarray, high: np.ndarray) -> None:
    margin = 0.03 * float((high - low).max())
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")


def camera(V: np.ndarray, F: np.ndarray) -> np.ndarray:
    """Rows: right, up and towards the eye; from above the mean normal, 35 degrees off it."""
    normals = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
    towards = normals.sum(0)
    if np.linalg.norm(towards) < 0.05 * np.linalg.norm(normals, axis=1).sum():  # all around, as a sphere
        towards = np.array([0.3, -1.0, 0.4])
    towards = towards / np.linalg.norm(towards)
    aside = np.array([0.25, -0.9, 0.1]) if abs(towards[2]) > 0.7 else np.array([0.3, 0.2, 0.9])
    aside = aside - aside @ towards * towards
    aside /= np.linalg.norm(aside)
    eye = np.cos(np.radians(50)) * towards + np.sin(np.radians(50)) * aside
    right = np.cross([0.0, 0.0, 1.0] if abs(eye[2]) <= 0.97 else [0.0, 1.0, 0.0], eye)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(eye, right), eye])


def _png(figure: Figure, dpi: int = 130, scale: bool = False) -> bytes:
    """A palette makes the file four times smaller. scale: colours stand for values, and stay as they are."""
    figure.set_dpi(dpi)
    pixels, size = FigureCanvasAgg(figure).print_to_buffer()
    image = Image.frombuffer("RGBA", size, pixels, "raw", "RGBA", 0, 1).convert("RGB")
    if not scale:
        image = image.quantize(256, Image.Quantize.FASTOCTREE)
    buffer = io.BytesIO()
    image.save(buffer, "png", dpi=(dpi, dpi))
    return buffer.getvalue()


MADE, PROPOSED = "#1565c0", "#d81b60"


def cut_view(design: Any, cuts: Sequence[dict], width: float = 10.0) -> bytes:
    """Layout on the left, target from two sides on the right; `cuts` as in report.json."""
    flat = np.asarray(design.T)
    figure = Figure(figsize=(width, _height(flat, 0.5 * width, 4, 10)))
    layout = figure.add_axes([0.01, 0.02, 0.5, 0.96])
    _draw_flat(layout, design, None)
    layout.axis("off")
    front = figure.add_axes([0.53, 0.51, 0.46, 0.47])
    behind = figure.add_axes([0.53, 0.02, 0.46, 0.47])
    sides = sides_of_edges(design.F)
    on_shape = []
    for number, cut in enumerate(cuts, 1):
        colour = MADE if cut["applied"] else PROPOSED
        edges = [(min(edge), max(edge)) for edge in cut["edges"]]
        lips = [flat[tile][[t, (t + 1) % 3]] for edge in edges for tile, t in sides[edge]]
        layout.add_collection(LineCollection(lips, colors=colour, linewidths=2))
        layout.annotate(str(number), np.mean(lips[len(lips) // 2], axis=0), color=colour,
                        fontsize=12, fontweight="bold")
        on_shape += [(*side, colour) for edge in edges for side in sides[edge]]
    for axes, turned in ((front, False), (behind, True)):
        _draw_actuated(axes, design, turned, lines=on_shape)
    return _png(figure)


SIDES = ("front", "back")
TAUT, WRINKLED, SLACK = range(3)  # as the native module numbers tension
WRINKLE, LOOSE = "#d81b60", "#b9b4aa"
LEVELS = 128  # colours of a membrane


def stretch_view(membranes: Sequence[Any], width: float = 10.0) -> bytes:
    """Both membranes side by side, coloured by the larger principal stretch on one scale; wrinkled
    triangles are tinted, slack ones grey. `membranes`: front and back, each with the arrays of a
    native MembranePicture."""
    points = np.vstack([membrane["flat"] for membrane in membranes])
    below, above = 0.75, 0.3  # inches, for the legend and the axis, and for titles
    height = _height(points, 0.405 * width, 2.2, 10) + below + above
    figure = Figure(figsize=(width, height))
    scale = _scale(membranes)
    for column, (name, membrane) in enumerate(zip(SIDES, membranes)):
        axes = figure.add_axes([0.05 + 0.455 * column, below / height, 0.405, 1 - (below + above) / height])
        drawn = _draw(axes, membrane, scale)
        _frame(axes, *_bounds(points))
        axes.set_title(name)
        _label(axes)
    figure.colorbar(drawn, cax=figure.add_axes([0.935, 0.2, 0.015, 0.65]), extend="both",
                    label="larger principal stretch")
    tension = np.concatenate([np.asarray(m["tension"]) for m in membranes])
    marks = [Patch(facecolor=colour, label=label) for kind, colour, label in
             ((WRINKLED, WRINKLE, "wrinkled: tinted"), (SLACK, LOOSE, "slack")) if (tension == kind).any()]
    if marks:
        figure.legend(handles=marks, loc="lower center", ncol=2, frameon=False)
    return _png(figure, scale=True)


def _scale(membranes: Sequence[Any]) -> Normalize:
    """Range from the first to the 99th hundredth of what carries tension: single triangles at corners of
    pins stretch much further and would leave one colour for all others."""
    carried = [np.asarray(m["stretch"])[np.asarray(m["tension"]) != SLACK, 0] for m in membranes]
    values = np.concatenate(carried)
    if not len(values):
        return Normalize(1.0, 2.0)
    low, high = np.percentile(values, [1, 99])
    return Normalize(low, max(high, low + 1e-3))


def _draw(axes: Any, membrane: Any, scale: Normalize) -> ScalarMappable:
    """Membrane on axes: one path for all triangles of a colour, as paths of their own take a hundred times
    longer. Triangles have no smooth edges, which would leave seams."""
    corners = np.asarray(membrane["flat"])[np.asarray(membrane["triangles"])]
    tension = np.asarray(membrane["tension"])
    colours = ScalarMappable(scale, "viridis")
    level = np.clip(scale(np.asarray(membrane["stretch"])[:, 0]) * LEVELS, 0, LEVELS - 1).astype(int)
    level[tension == SLACK] = LEVELS
    paints = [*colours.cmap((np.arange(LEVELS) + 0.5) / LEVELS), LOOSE]
    _add_triangles(axes, [(corners[level == k], paint) for k, paint in enumerate(paints)])
    _add_triangles(axes, [(corners[tension == WRINKLED], WRINKLE)], alpha=0.5)
    return colours


def _add_triangles(axes: Any, painted: Sequence[tuple[np.ndarray, Any]], alpha: float = 1.0) -> None:
    """Add triangles (N x 3 x 2) of each colour to axes."""
    codes = np.array([Path.MOVETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY], Path.code_type)
    shown = [(corners, paint) for corners, paint in painted if len(corners)]
    paths = [Path(np.concatenate([corners, corners[:, :1]], axis=1).reshape(-1, 2),
                  np.tile(codes, len(corners))) for corners, _ in shown]
    axes.add_collection(PathCollection(paths, facecolors=[paint for _, paint in shown], edgecolors="none",
                                       alpha=alpha, antialiaseds=False))
