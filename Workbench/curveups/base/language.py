# SPDX-License-Identifier: LGPL-2.1-or-later
"""Translates texts of sheets by the .ts files, without a window."""

from __future__ import annotations

import xml.etree.ElementTree as xml
from pathlib import Path
from typing import Any

from .errors import CurveUpsError
from .findings import Style
from .sentences import CONTEXT

SHEETS = "CurveUps_Sheets"  # context of translations
_FOLDER = Path(__file__).parents[3] / "resources" / "translations"


def Text(text: str) -> str:
    """Marks a text that a Language translates later. Its lines become one."""
    return " ".join(text.split())


class Language:
    """say(text, name=value) gives a text in the language, with the value for `{name}`. tools/translations
    finds texts that are given literally; a text without a translation stays as it is."""

    def __init__(self, name: str = "en"):
        if name not in languages():
            raise CurveUpsError(f"there is no language '{name}'", "--language",
                                f"give one of {', '.join(languages())}")
        self.name = name
        self.translations = {} if name == "en" else _read(_FOLDER / f"CurveUps_{name}.ts")

    def __call__(self, text: str, **values: Any) -> str:
        return " ".join(self.words(text).format(**values).split())

    def words(self, text: str) -> str:
        """A template, as it is."""
        return self.translations.get(text, text)

    @property
    def style(self) -> Style:
        """Style for sentences of findings."""
        return Style(self.words)


def languages() -> list[str]:
    """Names of the languages, English first."""
    return ["en", *sorted(path.stem.partition("_")[2] for path in _FOLDER.glob("CurveUps_*.ts"))]


def _read(path: Path) -> dict[str, str]:
    texts = {message.findtext("source", ""): message.findtext("translation", "")
             for context in xml.parse(path).getroot().iter("context")
             if context.findtext("name") in (SHEETS, CONTEXT) for message in context.iter("message")}
    return {text: said for text, said in texts.items() if said}


ENGLISH = Language()
