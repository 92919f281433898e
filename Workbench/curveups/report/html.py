# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages of HTML, from the templates beside this module; each is one file with its pictures inside."""

from __future__ import annotations

import base64
from html import escape
from importlib import import_module
from pathlib import Path
from typing import Any, Iterator, Mapping, Sequence, Union

from jinja2 import Environment, FileSystemLoader
from markupsafe import Markup

from ..base.errors import tile_list, tile_name
from ..base.parameters import table as parameter_table
from ..project.project import HOLDS, Results
from ..stages.actuation import states
from .assembly import steps
from .data import show
from .shop import latex, print_picture, quote, rules

Drawn = Union[bytes, Markup]  # PNG, or HTML that moves
# Modules of views and their functions: matplotlib is loaded where the first picture is drawn.
_VIEWS = {"flat": ("pictures", "flat_layout"), "actuated": ("pictures", "actuated_view"),
          "cuts": ("pictures", "cut_view"), "stretch": ("pictures", "stretch_view"),
          "movement": ("pictures", "movement_view"),
          "distance": ("pictures", "distance_view"), "blocked": ("pictures", "blocked_view"),
          "moving": ("actuation", "moving_view"), "print": ("print_pictures", "print_view")}
MOST_ROWS = 10  # of tables of moved vertices and weak contacts
STATE_NAMES = {"relaxed": "without friction", "by_itself": "released", "shaken": "shaken",
               "pressed": "pressed and let go"}


def view(name: str, **data: Any) -> Drawn:
    """Picture of `data` by the view of a name."""
    module, function = _VIEWS[name]
    return getattr(import_module(f".{module}", __package__), function)(**data)


def words(name: str) -> str:
    """Name of a figure as text."""
    return name.replace("_", " ")


def pair(tiles: Sequence[int]) -> str:
    """Names of the two tiles of a contact."""
    return "–".join(map(tile_name, tiles))


def _image(drawn: Drawn, caption: str) -> Markup:
    if not isinstance(drawn, bytes):
        return drawn
    data = base64.b64encode(drawn).decode("ascii")
    return Markup(f'<img alt="{escape(caption)}" src="data:image/png;base64,{data}">')


_TEMPLATES = Environment(loader=FileSystemLoader(Path(__file__).parent / "templates"), autoescape=True,
                         trim_blocks=True, lstrip_blocks=True)
_TEMPLATES.filters.update(show=show, tile=tile_name, tiles=tile_list, pair=pair, words=words, image=_image,
                          states=lambda block: states(block).items())
_TEMPLATES.globals.update(view=view, most=MOST_ROWS, states_in_words=STATE_NAMES)


def render(template: str, **data: Any) -> Markup:
    """Text of a template of this folder, filled in."""
    return Markup(_TEMPLATES.get_template(template).render(**data))


def build_html(results: Results, report: dict) -> str:
    """report.html for the results of a run and their report."""
    printed = print_picture(results)  # belongs to the shop's block
    parameters = results.parameters
    shop = {"rules": rules(report, parameters), "steps": steps(report, parameters),
            "quote": [*quote(report, parameters), ("Membranes", latex(report, parameters))]} \
        if "print" in report and "sheets" in report else None
    return render("report.html", title=report["title"], report=report, holds=HOLDS, shop=shop,
                  pictures=[*([printed] if printed else []), *results.pictures()],
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
