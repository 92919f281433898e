# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet for whoever builds the shell: parts, a step a page with a picture made from the design, and the
map of tiles."""

from __future__ import annotations

import io
from types import SimpleNamespace
from typing import Any, Callable, Iterator, Mapping

import numpy as np
from matplotlib.figure import Figure
from matplotlib.image import imread

from ..base import profiles
from ..base.language import Text
from ..report import pictures
from ..report.assembly import HOLE, glue_asked, glue_volumes, steps
from ..report.html import render
from ..report.print_pictures import print_view
from ..report.shop import latex
from . import drawing, latex as template
from .kit import Kit
from .maps import frame, tile_map, trim_view
from .ring_sheet import section


def make(kit: Kit, kind: str) -> bytes:
    """Make the sheet as html, which needs no other file, or as pdf."""
    return (_html if kind == "html" else _pdf)(kit)


def parts(kit: Kit) -> list[tuple[str, str]]:
    """Names and descriptions of all that is needed before the first step."""
    block, parameters, say = kit.report["print"], kit.results.parameters, kit.say
    glue, sheets, ring = glue_volumes(block["glue"]), kit.report["sheets"], kit.rings
    (width, height), (outer, high) = sheets["window_mm"], ring["outer_mm"]
    counts = [ring[side]["parts"] for side in ("front", "back")]
    joined = say("They come in {front} and {back} parts for the bed: split them in the slicer, and glue them "
                 "at their dovetails on a flat table.", front=counts[0], back=counts[1]) \
        if max(counts) > 1 else ""
    shear = glue_asked(kit.report)
    does = ", ".join(name for name in profiles.material_names("material_glue")
                     if profiles.parameters(profiles.material_path(name))["glue_strength"] >= shear)
    asked = " " + say("and that holds {shear:.2f} MPa in shear (of the program's materials: {does})",
                      shear=shear, does=does or say("none")) if shear else ""
    return [(say("Print"), say("{tiles} tiles and what holds them: {name}-shop.pdf is the order",
                               tiles=kit.report["tiles"], name=kit.name)),
            (say("Latex"), latex(kit.report, parameters, say)),
            (say("Templates"), say("{name}-latex-front.pdf and {name}-latex-back.pdf, printed at 100 %, the "
                                   "pages of one size of paper: A4, A3 or Letter", name=kit.name)),
            (say("Stretching rings"),
             say(_RINGS, name=kit.name, outer=outer, high=high, thickness=ring["thickness_mm"], width=width,
                 height=height, joined=joined, teeth=ring["teeth"], dowel=ring["dowel_mm"],
                 length=ring["dowel_length_mm"], tooth=ring["tooth_height_mm"],
                 rod=2 * ring["thickness_mm"] + ring["apart_mm"])),
            (say("Glue"), say("{front:.2f} cm³ for the front and {back:.2f} cm³ for the back, and half as "
                              "much again for the roller; a glue for rubber on hard plastic, that "
                              "water does not loosen{asked}; for rings in parts or with dowels also a rigid "
                              "one", asked=asked, **glue)),
            *_shaping(kit),
            (say("Tools"), say("strong scissors, a sharp punch of {punch:g} mm, a pen whose ink stays on "
                               "latex, carbon paper, tape, dish soap, a roller, a ruler, two boards thicker "
                               "than a ring ({thickness:g} mm), larger than the print and smaller than the "
                               "window, weights, gloves, goggles", punch=HOLE * sheets["grid_mm"],
                               thickness=ring["thickness_mm"]))]


_RINGS = Text("""two frames of {outer:.0f} × {high:.0f} × {thickness:g} mm around a window of {width:.0f} ×
{height:.0f} mm. Print {name}-ring-front.step and {name}-ring-back.step, or their STL, of rigid plastic,
lying flat with the teeth up. {joined} Or saw them of plywood of that thickness ({name}-ring-front.dxf and
{name}-ring-back.dxf) and glue {teeth} dowels of {dowel:g} × {length:g} mm into each as teeth, of which
{tooth:g} mm stick out, their ends rounded and sanded. 4 rods of {dowel:g} × {rod:g} mm in the holes at the
corners align the rings""")


def _shaping(kit: Kit) -> list[tuple[str, str]]:
    """Former of the shell, and frame of a print in several parts."""
    say = kit.say
    rows = [(say("Former"), say("{name}-former.stl, {volume:.0f} cm³, printed hollow of any plastic",
                                name=kit.name, volume=sum(former.volume for former in kit.formers)))]
    if kit.beds and kit.beds.seams and kit.model.outlines:
        rows.append((say("Frame"), say("a plate 3 mm thick, cut by {name}-frame.dxf, for the {count} parts "
                                       "of the print", name=kit.name,
                                       count=sum(map(len, kit.beds.places)))))
    return rows


def _shown(kit: Kit, name: str) -> bytes:
    """A picture as PNG, drawn once for html and pdf."""
    if name not in kit.pictures:
        kit.pictures[name] = _PICTURES[name](kit)
    return kit.pictures[name]


_PICTURES: Mapping[str, Callable[[Kit], bytes]] = {
    "template": lambda kit: _drawn(template.template(kit.title, kit.report["sheets"], say=kit.say)),
    "stretched": lambda kit: _drawn(template.template(kit.title, kit.report["sheets"], True, kit.say)),
    "section": lambda kit: _drawn(section(kit)),
    "frame": lambda kit: _drawn(frame(kit)),
    "print": lambda kit: print_view(kit.prints, kit.printer["bed_mm"], say=kit.say),
    "front": lambda kit: pictures.flat_layout(kit.results.design),
    "back": lambda kit: pictures.flat_layout(_from_back(kit)),
    "actuated": lambda kit: pictures.actuated_view(kit.results.design),
    "trim": trim_view,
    "map": lambda kit: _drawn(tile_map(kit))}


def _from_back(kit: Kit) -> Any:
    """Faces and pins of the back as flat_layout takes them; corners are counter-clockwise again."""
    T = kit.shapes.flat[:, [5, 4, 3], :2] * (-1, 1)
    q = np.asarray(kit.results.design.q)[:, ::-1][:, :, [1, 0, 2]]
    return SimpleNamespace(T=T, q=q)


def _drawn(shown: drawing.Drawing) -> bytes:
    """A drawing as PNG, 160 mm wide."""
    return pictures._png(drawing.whole(shown, 160.0), 160)


def _pages(kit: Kit) -> list[tuple[str, str, str]]:
    """Title, text and picture of each step."""
    return [(f"{number}. {step.title}", step.text, step.picture)
            for number, step in enumerate(steps(kit.report, kit.results.parameters, kit.say), 1)]


def _html(kit: Kit) -> bytes:
    def drawn(name: str) -> bytes:
        kit.go_on()
        return _shown(kit, name)

    say = kit.say
    return render("assembly.html", title=kit.title, language=say.name, heading=_title(kit), parts=parts(kit),
                  steps=_pages(kit), drawn=drawn, map=say(_MAP), of_map=say(_OF_MAP, name=kit.name)
                  ).encode("utf-8")


def _pdf(kit: Kit) -> bytes:
    say = kit.say

    def pages() -> Iterator[Figure]:
        figure, canvas, top = _page(_title(kit))
        drawing.write(canvas, drawing.BORDER, top, [f"{label}: {text}." for label, text in parts(kit)], 11)
        yield figure
        last = say(_MAP), say(_OF_MAP, name=kit.name), "map"
        for title, text, name in (*_pages(kit), last):
            figure, canvas, top = _page(title)
            top = drawing.write(canvas, drawing.BORDER, top, [text], 9.5 if name == "map" else 11)
            _show(figure, _shown(kit, name), top)
            yield figure

    return drawing.book(pages(), kit.go_on)


_MAP = Text("Map of tiles")
_OF_MAP = Text("""Numbers of tiles from the front, and mirrored from the back: 12 is T00012. Red: tiles of
the weakest contacts. {name}-tiles.svg has it large enough to read.""")


def _title(kit: Kit) -> str:
    return kit.say("{title}: assembly", title=kit.title)


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
