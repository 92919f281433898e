# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings at full size: lines, circles and texts on layers, lengths in mm, y up; as SVG, as DXF and as PDF
in sheets of paper. The same drawing gives the same bytes: no dates, no random ids."""

from __future__ import annotations

import io
from dataclasses import dataclass, field
from typing import Any, Callable, Iterator, Sequence

import ezdxf
import numpy as np
from ezdxf.math import Vec2
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.patches import Circle
from matplotlib.textpath import text_to_path

from ..base.language import ENGLISH, Language
from ..report import pictures  # noqa: F401 (sets matplotlib up for work without a display)

INCH = 25.4
DOTS = 220  # of an inch, where pages hold pictures
PAPERS = {"A4": (210.0, 297.0), "A3": (297.0, 420.0), "Letter": (215.9, 279.4)}
BORDER = 12.0   # mm of paper that printers leave white, and the crosses' room
OVERLAP = 10.0  # mm that neighbouring sheets of paper share
RULER = 100.0   # mm
FOOT = 22.0     # mm for the ruler and the words below
# Layers: colour, that of DXF, and width in points.
LAYERS = {"cut": ("#c62828", 1, 0.8), "grid": ("#2f6f9f", 5, 0.4), "control": ("#1c7a2a", 3, 1.0),
          "text": ("#2b2620", 7, 0.0)}
POINT = 72 / INCH  # points of a mm
CAPITALS = 0.73    # height of a capital letter, of the font's size
Box = tuple[float, float, float, float]  # left, lower, width, height


@dataclass
class Drawing:
    """lines, circles (x, y, radius) and texts (x, y, height, text) by layer, of LAYERS."""

    title: str
    size: tuple[float, float]
    lines: dict[str, list[np.ndarray]] = field(default_factory=dict)
    circles: dict[str, list[tuple[float, float, float]]] = field(default_factory=dict)
    texts: list[tuple[float, float, float, str]] = field(default_factory=list)

    def line(self, layer: str, *points: Sequence[float]) -> None:
        """An open line through these points."""
        self.lines.setdefault(layer, []).append(np.asarray(points, float))

    def box(self, layer: str, x: float, y: float, width: float, height: float) -> None:
        """The outline of a rectangle from its lower left corner."""
        self.line(layer, (x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y))

    def closed(self, layer: str, points: np.ndarray) -> None:
        """The line around an area, n x 2 points."""
        self.line(layer, *points, points[0])

    def circle(self, layer: str, x: float, y: float, radius: float) -> None:
        self.circles.setdefault(layer, []).append((x, y, radius))

    def text(self, x: float, y: float, height: float, text: str) -> None:
        """Words that begin at a point."""
        self.texts.append((x, y, height, text))

    def fitted(self, x: float, y: float, height: float, text: str, room: float) -> None:
        """Words that begin at a point, smaller where they would be wider than `room`."""
        wide = _width(text, height * POINT / CAPITALS)
        self.text(x, y, height * min(1.0, room / max(wide, 1e-9)), text)

    def centred(self, x: float, y: float, height: float, text: str) -> None:
        """Words around a point."""
        self.text(x - _width(text, height * POINT / CAPITALS) / 2, y - height / 2, height, text)

    def within(self, part: Box) -> Drawing:
        """Drawing of all that reaches, or may reach, into a box."""
        def seen(low: Any, high: Any) -> bool:
            x, y, width, height = part
            return bool(low[0] < x + width and high[0] > x and low[1] < y + height and high[1] > y)

        lines = {layer: [line for line in lines if seen(line.min(0), line.max(0))]
                 for layer, lines in self.lines.items()}
        circles = {layer: [(x, y, r) for x, y, r in circles if seen((x - r, y - r), (x + r, y + r))]
                   for layer, circles in self.circles.items()}
        # No letter is wider than twice the height of capitals.
        texts = [(x, y, size, text) for x, y, size, text in self.texts
                 if seen((x - size, y - size), (x + 2 * size * len(text), y + 2 * size))]
        return Drawing(self.title, self.size, {layer: shapes for layer, shapes in lines.items() if shapes},
                       {layer: shapes for layer, shapes in circles.items() if shapes}, texts)


def written(drawing: Drawing, kind: str, notes: Sequence[str] = (),
            go_on: Callable[[], object] = lambda: None, say: Language = ENGLISH) -> bytes:
    """Bytes of a drawing as svg, dxf or pdf. notes, go_on, say: of a pdf."""
    if kind == "pdf":
        return tiled_pdf(drawing, notes, go_on, say)
    return (svg if kind == "svg" else dxf)(drawing)


def svg(drawing: Drawing) -> bytes:
    """Draw an SVG with a group for each layer."""
    figure, axes = sheet(*drawing.size)
    draw(axes, drawing)
    stream = io.BytesIO()
    figure.savefig(stream, format="svg", dpi=DOTS, metadata={"Date": None})
    return stream.getvalue()


def dxf(drawing: Drawing) -> bytes:
    """R2000, in mm, with a layer each."""
    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True  # fixed dates and ids
    try:
        document = ezdxf.new("R2000", units=4)
        space = document.modelspace()
        for layer in (*drawing.lines, *drawing.circles, "text"):
            if layer not in document.layers:
                document.layers.add(layer, color=LAYERS[layer][1])
        for layer, lines in drawing.lines.items():
            for points in lines:
                space.add_lwpolyline(points.tolist(), dxfattribs={"layer": layer})
        for layer, circles in drawing.circles.items():
            for x, y, radius in circles:
                space.add_circle((x, y), radius, dxfattribs={"layer": layer})
        for x, y, height, text in drawing.texts:
            space.add_text(text, dxfattribs={"layer": "text", "height": height, "insert": Vec2(x, y)})
        stream = io.StringIO()
        document.write(stream)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before
    return stream.getvalue().encode(document.output_encoding, errors="dxfreplace")


def whole(drawing: Drawing, width: float) -> Figure:
    """All of a drawing in a picture so wide, mm."""
    scale = width / drawing.size[0]
    figure, axes = sheet(width, drawing.size[1] * scale)
    show_part(axes, (0, 0, *drawing.size))
    draw(axes, drawing, scale)
    return figure


def sheet(width: float, height: float) -> tuple[Figure, Any]:
    """A figure of this size, mm, and axes whose units are mm from its lower left corner."""
    figure = Figure(figsize=(width / INCH, height / INCH))
    axes = figure.add_axes([0, 0, 1, 1])
    show_part(axes, (0, 0, width, height))
    return figure, axes


def show_part(axes: Any, part: Box) -> None:
    """Axes that show this part alone, without ticks."""
    x, y, width, height = part
    axes.set_xlim(x, x + width)
    axes.set_ylim(y, y + height)
    axes.axis("off")


def book(figures: Iterator[Figure], go_on: Callable[[], object] = lambda: None) -> bytes:
    """A PDF with a page a figure."""
    stream = io.BytesIO()
    with PdfPages(stream, metadata={"CreationDate": None, "Producer": None, "Creator": None}) as pages:
        for figure in figures:
            pages.savefig(figure, dpi=DOTS)
            go_on()
    return stream.getvalue()


def tiles(drawing: Drawing, paper: str) -> list[tuple[int, int, Box]]:
    """Column, row (of paper, from the top left) and part of the drawing on each sheet of paper; sheets
    without a line are left out."""
    width, height = PAPERS[paper][0] - 2 * BORDER, PAPERS[paper][1] - 2 * BORDER - FOOT
    columns, rows = (max(1, int(np.ceil((size - OVERLAP) / (room - OVERLAP))))
                     for size, room in zip(drawing.size, (width, height)))
    sheets = []
    for row in range(rows):
        for column in range(columns):
            x = column * (width - OVERLAP)
            part = x, drawing.size[1] - height - row * (height - OVERLAP), width, height
            shown = drawing.within(part)
            if shown.lines or shown.circles:
                sheets.append((column, row, part))
    return sheets


def tiled_pdf(drawing: Drawing, notes: Sequence[str], go_on: Callable[[], object], say: Language = ENGLISH
              ) -> bytes:
    """Draw, for each paper, a cover with the whole and its parts, then the parts at full size."""
    def pages() -> Iterator[Figure]:
        for paper in PAPERS:
            parts = tiles(drawing, paper)
            yield _cover(drawing, paper, parts, notes, say)
            for number, part in enumerate(parts, 1):
                yield _part(drawing, paper, number, len(parts), part, say)

    return book(pages(), go_on)


def _cover(drawing: Drawing, paper: str, parts: Sequence[Any], notes: Sequence[str], say: Language) -> Figure:
    width, height = PAPERS[paper]
    figure, page = sheet(width, height)
    top = write(page, BORDER, height - BORDER, [drawing.title], 15)
    top = write(page, BORDER, top - 2, [
        say("For {paper} paper: print at 100 % (“actual size”), not fitted to the page; measure the ruler.",
            paper=paper),
        say("{count} pages follow, which overlap by {overlap:g} mm: lay cross on cross. This page shows the "
            "whole, and which page has which part.", count=len(parts), overlap=OVERLAP)
        if len(parts) > 1 else say("One page follows."), *notes], 9.5)
    room = (width - 2 * BORDER, top - 2 * BORDER)
    scale = min(room[0] / drawing.size[0], room[1] / drawing.size[1])
    inner = figure.add_axes([BORDER / width, BORDER / height, drawing.size[0] * scale / width,
                             drawing.size[1] * scale / height])
    show_part(inner, (0, 0, *drawing.size))
    draw(inner, drawing, scale)
    for number, (_, _, (x, y, w, h)) in enumerate(parts, 1):
        x0, x1, y0, y1 = max(x, 0), min(x + w, drawing.size[0]), max(y, 0), min(y + h, drawing.size[1])
        inner.plot([x0, x1, x1, x0, x0], [y0, y0, y1, y1, y0], "--", color="#888888", linewidth=0.6,
                   clip_on=False)
        inner.text((x0 + x1) / 2, (y0 + y1) / 2, str(number), size=26, color="#999999", ha="center",
                   va="center")
    return figure


def _part(drawing: Drawing, paper: str, number: int, count: int, part: tuple[int, int, Box], say: Language
          ) -> Figure:
    width, height = PAPERS[paper]
    figure, page = sheet(width, height)
    column, row, (_, _, w, h) = part
    inner = figure.add_axes([BORDER / width, (BORDER + FOOT) / height, w / width, h / height])
    show_part(inner, part[2])
    draw(inner, drawing.within(part[2]))
    for u in (BORDER + OVERLAP / 2, width - BORDER - OVERLAP / 2):
        for v in (BORDER + FOOT + OVERLAP / 2, height - BORDER - OVERLAP / 2):
            page.plot([u - 4, u + 4], [v, v], color="#555555", linewidth=0.4)
            page.plot([u, u], [v - 4, v + 4], color="#555555", linewidth=0.4)
    ruler(page, BORDER + 4, BORDER + 10)
    page.text(BORDER + 4, BORDER, say(
        "{title}: {paper}, page {number} of {count} (column {column}, row {row}). Print at 100 %: the ruler "
        "is {ruler:g} mm long.", title=drawing.title, paper=paper, number=number, count=count,
        column=column + 1, row=row + 1, ruler=RULER), size=8)
    return figure


def ruler(page: Any, x: float, y: float) -> None:
    """A labelled ruler of 100 mm from its lower left end."""
    page.plot([x, x + RULER], [y, y], color="black", linewidth=0.5, solid_capstyle="butt")
    for k in range(int(RULER) // 10 + 1):
        end = k in (0, int(RULER) // 10)
        page.plot([x + 10 * k] * 2, [y, y + (5 if end else 2.5)], color="black", linewidth=0.5)
        if k % 5 == 0:
            page.text(x + 10 * k, y + 5.5, f"{10 * k} mm", size=7, ha="center")


def write(page: Any, x: float, top: float, lines: Sequence[str], size: float, columns: float = 0.0) -> float:
    """Writes paragraphs down from `top` and returns where they end. columns: mm of a line; the page's."""
    room = columns or page.get_xlim()[1] - x - BORDER
    for line in lines:
        for piece in wrapped(line, room, size):
            top -= size / POINT * 1.25
            page.text(x, top, piece, size=size)
        top -= size / POINT * 0.4
    return top


def wrapped(text: str, room: float, size: float) -> list[str]:
    """Lines that are no wider than `room`, mm."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and _width(longer, size) > room:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def _width(text: str, size: float) -> float:
    """Width of words in letters of this size, mm."""
    font = FontProperties(size=size)
    return float(text_to_path.get_text_width_height_descent(text, font, False)[0]) / POINT


def draw(axes: Any, drawing: Drawing, scale: float = 1.0) -> None:
    """Draw on axes whose limits are set. scale: of letters, sized in points."""
    for layer, lines in drawing.lines.items():
        colour, _, width = LAYERS[layer]
        axes.add_collection(LineCollection(lines, colors=colour, linewidths=width, gid=layer), autolim=False)
    for layer, circles in drawing.circles.items():
        for x, y, radius in circles:
            axes.add_artist(Circle((x, y), radius, fill=False, edgecolor=LAYERS[layer][0], linewidth=0.5,
                                   gid=layer))
    for x, y, height, text in drawing.texts:
        axes.text(x, y, text, size=height * POINT * scale / CAPITALS, color=LAYERS["text"][0], clip_on=True,
                  bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 0})  # over lines
