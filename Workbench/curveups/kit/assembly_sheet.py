# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet for whoever builds the shell: parts, a step a page with a picture made from the design, and the
map of tiles."""

from __future__ import annotations

import io
from functools import partial
from html import escape
from types import SimpleNamespace
from typing import Any, Callable, Iterator, Mapping

import numpy as np
from matplotlib.figure import Figure
from matplotlib.image import imread

from ..report import pictures
from ..report.assembly import Step, glue_volumes, steps
from ..report.html import page, picture
from ..report.print_pictures import print_view
from ..report.shop import latex
from ..report.tables import table
from . import drawing, latex as template
from .bed_files import frame
from .kit import Kit
from .tile_map import tile_map
from .trim import marks
from .underside import figures


def make(kit: Kit, kind: str) -> bytes:
    """As html, which needs nothing beside it, or as pdf."""
    return (_html if kind == "html" else _pdf)(kit)


def parts(kit: Kit) -> list[tuple[str, str]]:
    """What has to be there before the first step."""
    block, parameters = kit.report["print"], kit.results.parameters
    glue, sheets = glue_volumes(block["glue"]), kit.report["sheets"]
    ring = kit.rings
    (width, height), (outer, high) = sheets["window_mm"], ring["outer_mm"]
    return [("Print", f"{block['bodies']} bodies, {kit.report['tiles']} of them tiles, as on "
                      f"{kit.name}-shop.pdf"),
            ("Latex", latex(kit.report, parameters)),
            ("Templates", f"{kit.name}-latex-front.pdf and {kit.name}-latex-back.pdf, printed at 100 %"),
            ("Stretching rings",
             f"two frames of {outer:.0f} × {high:.0f} × {ring['thickness_mm']:g} mm around a window of "
             f"{width:.0f} × {height:.0f} mm. Print {kit.name}-ring-front.step and -back.step, or their STL, "
             f"of rigid plastic{_of_parts(ring)}; or saw plywood as thick ({kit.name}-ring-front.dxf and "
             f"-back.dxf) and glue in {2 * ring['teeth']} dowels of {ring['dowel_mm']:g} × "
             f"{ring['dowel_length_mm']:g} mm as teeth, of which {ring['tooth_height_mm']:g} mm stick out, "
             f"their ends rounded and sanded. 4 rods of {ring['dowel_mm']:g} × "
             f"{2 * ring['thickness_mm'] + ring['apart_mm']:g} mm at the corners align the rings"),
            ("Glue", f"{glue['front']:.2f} cm³ for the front and {glue['back']:.2f} cm³ for the back, and "
                     "half as much again for the roller; a flexible glue for rubber on hard plastic"),
            *_shaping(kit),
            ("Coupons", f"{kit.name}-coupons.pdf in the folder coupons says what to print and to measure "
                        "before the order"),
            ("Time and cost of the print", "; ".join(_cost(number, one) for number, one in
                                                     enumerate(kit.report["costs"], 1))),
            ("Tools", "scissors, a pen whose ink stays on latex, a roller, a ruler, gloves")]


def _shaping(kit: Kit) -> list[tuple[str, str]]:
    """What the shell is brought into shape on, and what parts of the print butt in."""
    made = figures(kit.undersides)
    ribs = f"{len(made['ribs'])} ribs of a sheet {made['sheet_mm']:g} mm thick ({kit.name}-gauges.dxf), or "
    found = [("Ribs or former", (ribs if made["ribs"] else "")
              + f"{kit.name}-former.stl, {made['former_cm3']:.0f} cm³, printed hollow of anything")]
    if kit.beds and kit.beds.seams and kit.model.outlines:
        found.append(("Frame", f"a plate 3 mm thick, cut by {kit.name}-frame.dxf, for the "
                               f"{sum(map(len, kit.beds.places))} parts of the print"))
    return found


def _cost(number: int, one: Mapping[str, Any]) -> str:
    return (f"bed {number}: {one['hours']:.1f} h (by {one['hours_by']}), {one['price']:.0f} "
            f"{one['currency']} at the prices in the printer's file")


def _of_parts(ring: Mapping[str, Any]) -> str:
    counts = [ring[side]["parts"] for side in ("front", "back")]
    return (f", in {counts[0]} and {counts[1]} parts for the bed, which are glued at their dovetails on "
            "a flat table" if max(counts) > 1 else "")


def _pictures(kit: Kit) -> dict[str, Callable[[], bytes]]:
    """How the pictures of steps are drawn, by their names."""
    design, block = kit.results.design, kit.report["sheets"]
    bed = kit.printer["bed_mm"]
    return {"template": lambda: _drawn(template.template(kit.title, block)),
            "stretched": lambda: _drawn(template.template(kit.title, block, True)),
            "frame": lambda: _drawn(frame(kit)),
            "print": partial(print_view, kit.model, bed),
            "front": partial(pictures.flat_layout, design),
            "back": lambda: pictures.flat_layout(_from_back(kit)),
            "actuated": partial(pictures.actuated_view, design),
            "trim": lambda: _drawn(marks(kit)),
            "map": lambda: _drawn(tile_map(kit))}


def _from_back(kit: Kit) -> Any:
    """Faces and pins of the back as flat_layout takes them; corners are counter-clockwise again."""
    T = kit.shapes.flat[:, [5, 4, 3], :2] * (-1, 1)
    q = np.asarray(kit.results.design.q)[:, ::-1][:, :, [1, 0, 2]]
    return SimpleNamespace(T=T, q=q)


def _drawn(one: drawing.Drawing) -> bytes:
    """A drawing as PNG, 160 mm wide."""
    return pictures._png(drawing.whole(one, 160.0), 160)


def _html(kit: Kit) -> bytes:
    shown = _pictures(kit)
    found = [f"<h1>{escape(kit.title)}: assembly</h1>", table(parts(kit))]
    for number, step in enumerate(steps(kit.report, kit.results.parameters), 1):
        kit.go_on()
        found += [f"<h2>{number}. {escape(step.title)}</h2>", f"<p>{escape(_sentence(step))}</p>"]
        found += [picture(shown[step.picture](), "")] if step.picture else []
    found += ["<h2>Map of tiles</h2>", picture(shown["map"](), _MAP)]
    return page(kit.title, found).encode("utf-8")


def _pdf(kit: Kit) -> bytes:
    shown = _pictures(kit)

    def pages() -> Iterator[Figure]:
        figure, canvas, top = _page(f"{kit.title}: assembly")
        drawing.write(canvas, drawing.BORDER, top, [f"{label}: {text}." for label, text in parts(kit)], 11)
        yield figure
        for number, step in enumerate(steps(kit.report, kit.results.parameters), 1):
            figure, canvas, top = _page(f"{number}. {step.title}")
            top = drawing.write(canvas, drawing.BORDER, top, [_sentence(step)], 11)
            _show(figure, shown[step.picture](), top)
            yield figure
        figure, canvas, top = _page("Map of tiles")
        _show(figure, shown["map"](), drawing.write(canvas, drawing.BORDER, top, [_MAP], 9.5))
        yield figure

    return drawing.book(pages(), kit.go_on)


_MAP = ("Numbers of tiles from the front, and mirrored from the back: 12 is T00012. Red: tiles of the "
        "weakest contacts. The file -tiles.svg has it large enough to read.")


def _sentence(step: Step) -> str:
    return step.text[0].upper() + step.text[1:]


def _page(title: str) -> tuple[Figure, Any, float]:
    """A4, and where what follows the title begins."""
    figure, canvas = drawing.sheet(*drawing.PAPERS["A4"])
    top = drawing.write(canvas, drawing.BORDER, drawing.PAPERS["A4"][1] - drawing.BORDER, [title], 17)
    return figure, canvas, top - 2


def _show(figure: Figure, png: bytes, top: float) -> None:
    """A picture between `top` and the lower border."""
    (width, height), border = drawing.PAPERS["A4"], drawing.BORDER
    axes = figure.add_axes([border / width, border / height, 1 - 2 * border / width, (top - border) / height])
    axes.imshow(imread(io.BytesIO(png)), interpolation="none")
    axes.set_anchor("N")
    axes.axis("off")
