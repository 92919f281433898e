# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages of HTML, from the templates beside this module; each is one file with its pictures inside."""

from __future__ import annotations

import base64
from functools import lru_cache
from html import escape
from importlib import import_module
from pathlib import Path
from typing import Any, Iterator, Mapping, Optional, Sequence, Union

from ..base.errors import tile_list, tile_name
from ..base.parameters import table as parameter_table
from ..project.project import HOLDS, Results
from ..stages.actuation import states
from ..stages.stage import Picture
from .assembly import steps
from .data import show
from .shop import latex, print_picture, quote, rules

Drawn = Union[bytes, str]  # PNG, or HTML that moves
MOST_ROWS = 10  # of tables of moved vertices and weak contacts
STATE_NAMES = {"relaxed": "without friction", "by_itself": "released", "shaken": "shaken",
               "pressed": "pressed and let go"}


def view(place: str, **data: Any) -> Drawn:
    """Picture of `data` (stage.Picture). matplotlib is loaded where the first one is drawn."""
    module, function = place.split(".")
    return getattr(import_module(f".{module}", __package__), function)(**data)


def words(name: str) -> str:
    """Name of a figure as text."""
    return name.replace("_", " ")


def pair(tiles: Sequence[int]) -> str:
    """Names of the two tiles of a contact."""
    return "–".join(map(tile_name, tiles))


def _image(drawn: Drawn, caption: str) -> str:
    if not isinstance(drawn, bytes):
        return drawn
    data = base64.b64encode(drawn).decode("ascii")
    return markup(f'<img alt="{escape(caption)}" src="data:image/png;base64,{data}">')


def markup(text: str) -> str:
    """Text that templates take as HTML."""
    from markupsafe import Markup  # which FreeCAD may lack

    return Markup(text)


@lru_cache(maxsize=None)
def _templates() -> Any:
    from jinja2 import Environment, FileSystemLoader  # which FreeCAD may lack

    templates = Environment(loader=FileSystemLoader(Path(__file__).parent / "templates"), autoescape=True,
                            trim_blocks=True, lstrip_blocks=True)
    templates.filters.update(show=show, tile=tile_name, tiles=tile_list, pair=pair, words=words, image=_image,
                             states=lambda block: states(block).items())
    templates.globals.update(view=view, most=MOST_ROWS, states_in_words=STATE_NAMES)
    return templates


def render(template: str, **data: Any) -> str:
    """Text of a template of this folder, filled in."""
    return markup(_templates().get_template(template).render(**data))


def draw_pictures(results: Results) -> list[tuple[Picture, Drawn]]:
    """All pictures of report.html."""
    printed = print_picture(results)  # belongs to the shop's block
    return [(picture, view(picture.view, **picture.data))
            for picture in (*([printed] if printed else []), *results.pictures())]


def build_html(results: Results, report: dict,
               drawn: Optional[Sequence[tuple[Picture, Drawn]]] = None) -> str:
    """report.html for the results of a run and their report. drawn: its pictures, where they are drawn
    already."""
    parameters = results.parameters
    shop = {"rules": rules(report, parameters), "steps": steps(report, parameters),
            "quote": [*quote(report, parameters), ("Membranes", latex(report, parameters))]} \
        if "print" in report and "sheets" in report else None
    return render("report.html", title=report["title"], report=report, holds=HOLDS, shop=shop,
                  pictures=draw_pictures(results) if drawn is None else drawn,
                  figures=list(_figures(report)), parameters=parameter_table(),
                  values=parameters.to_dict())


# Times and memory stay out: the same design gives the same page.
_BLOCKS = ("area", "constraints", "target", "deviation", "layout", "truncation", "physics", "contact_forces",
           "unilateral", "settled", "margin", "clearances", "solids")
_NO_FIGURES = ("invalid_contacts", "open_contacts", "notes", "unit")
_FORCES = ("normal_mean", "normal_min", "f_min", "floor", "largest_floor", "mean_tile_force")  # N
_UNITS = {"mm": "mm", "mm2": "mm²", "mm3": "mm³", "cm2": "cm²", "cm3": "cm³"}


def _figures(report: Mapping[str, Any]) -> Iterator[tuple[str, list[tuple[str, str]]]]:
    """Heading and rows of each block of figures."""
    for block in _BLOCKS:
        rows = []
        for key, value in report.get(block, {}).items():
            if isinstance(value, dict):
                rows += [(f"{words(key)}: {words(inner)}", show(item)) for inner, item in value.items()]
            elif key not in _NO_FIGURES:
                rows.append(_figure(key, value))
        if rows:
            yield words(block).capitalize(), rows


def _figure(key: str, value: Any) -> tuple[str, str]:
    stem, _, end = key.rpartition("_")
    if end in _UNITS:
        return words(stem), f"{show(value)} {_UNITS[end]}"
    return words(key), f"{show(value)}{' N' if key in _FORCES else ''}"
