# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings: reasons, warnings and advice on a target, a design or its print, as values. A sentence is made
here alone: the template of its kind (sentences.py) is translated first and then filled in with figures."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, ClassVar, Iterable, Mapping, Sequence

from .errors import CurveUpsError, tile_name
from .sentences import MORE, SENTENCES, WORDS


class Value:
    """Base of frozen dataclasses that can be saved; `known` has them by name."""

    known: ClassVar[dict[str, type]] = {}

    def __init_subclass__(cls) -> None:
        Value.known[cls.__name__] = cls


@dataclass(frozen=True)
class Style:
    """Style of a sentence. words: translates a template. tile: names a row of F. plain: writes a text
    (escaped, say). quantity: writes a number by its format and its unit."""

    words: Callable[[str], str] = str
    tile: Callable[[int], str] = tile_name
    plain: Callable[[str], str] = str
    quantity: Callable[[float, str, str], str] = lambda number, how, unit: f"{number:{how}} {unit}"


ENGLISH = Style()


@dataclass(frozen=True)
class Finding(Value):
    """kind: key of SENTENCES; report.json has the part before its first dot. tiles: rows of F concerned,
    ascending; empty: all of the design. figures: values for the template: numbers, words, rows (of F, or of a
    file's faces or vertices), pairs of rows of F, other findings."""

    kind: str
    tiles: tuple[int, ...] = ()
    figures: Mapping[str, Any] = field(default_factory=dict)

    @classmethod
    def of(cls, finding: Any) -> "Finding":
        """The value of a native Finding."""
        return cls(finding.kind, tuple(finding.tiles),
                   {name: _figure(figure) for name, figure in finding.figures.items()})

    @classmethod
    def about(cls, kind: str, tiles: Iterable[int] = (), **figures: Any) -> "Finding":
        """Finding with figures by their names."""
        return cls(kind, tuple(sorted({int(tile) for tile in tiles})), figures)

    @classmethod
    def read(cls, data: Any) -> "Finding":
        """Inverse of `data`. Raises LookupError, TypeError or ValueError for damaged data."""
        return cls(str(data["kind"]), tuple(map(int, data["tiles"])),
                   {str(name): _read(figure) for name, figure in dict(data["figures"]).items()})

    @property
    def data(self) -> dict[str, Any]:
        """Entries of a JSON file."""
        return {"kind": self.kind, "tiles": self.tiles,
                "figures": {name: _plain(figure, lambda finding: finding.data)
                            for name, figure in self.figures.items()}}

    @property
    def group(self) -> str:
        """Kind in report.json."""
        return self.kind.partition(".")[0]

    def __str__(self) -> str:
        return self.sentence()

    def sentence(self, style: Style = ENGLISH) -> str:
        """Statement of the finding."""
        return self._write(0, style)

    def remedy(self, style: Style = ENGLISH) -> str:
        """Remedy; empty where none is known."""
        return self._write(1, style)

    def concerns(self, tiles: Iterable[int]) -> bool:
        """True where it concerns one of these tiles, or all."""
        return not self.tiles or not set(self.tiles).isdisjoint(tiles)

    def entry(self) -> dict[str, Any]:
        """Entry of report.json."""
        remedy, figures = self.remedy(), {name: _plain(figure) for name, figure in self.figures.items()}
        return {**figures, "what": str(self), "kind": self.group, **({"remedy": remedy} if remedy else {}),
                "tiles": list(self.tiles)}

    def _write(self, part: int, style: Style) -> str:
        texts = SENTENCES.get(self.kind, (self.kind, ""))
        try:
            return style.plain(style.words(texts[part])).format_map(
                {name: _Shown(figure, style) for name, figure in self.figures.items()}) if texts[part] else ""
        except (ArithmeticError, LookupError, TypeError, ValueError):
            return style.plain(self.kind)  # in a damaged document


class _Shown:
    """A figure in a sentence, formatted by the text after the colon in the template: of a number Python's
    format and a unit; of rows how many are named, after "#" where they are no tiles; of findings a
    separator."""

    def __init__(self, figure: Any, style: Style):
        self._figure, self._style = figure, style

    def __format__(self, how: str) -> str:
        figure, style = self._figure, self._style
        if isinstance(figure, Finding):
            return figure.sentence(style)
        if isinstance(figure, str):
            sentence = " " in figure  # of an error; names have no spaces
            return style.plain(style.words(figure) if sentence or figure in WORDS else figure)
        if not isinstance(figure, tuple):
            number, _, unit = how.partition(" ")
            return style.quantity(figure, number, unit) if unit else format(figure, number)
        if figure and isinstance(figure[0], Finding):
            return style.plain(style.words(how)).join(finding.sentence(style) for finding in figure)
        most = int(how.lstrip("#") or len(figure))
        names = ", ".join("-".join(map(style.tile, row)) if isinstance(row, tuple)
                          else str(row + 1) if how.startswith("#") else style.tile(row)
                          for row in figure[:most])
        left = len(figure) - most
        return names + (style.plain(style.words(MORE)).format(count=left) if left > 0 else "")


def all_of(findings: Iterable[Any]) -> tuple[Finding, ...]:
    """Values of native findings."""
    return tuple(map(Finding.of, findings))


def unique(findings: Sequence[Finding]) -> tuple[Finding, ...]:
    """Each finding once: several results may give the same."""
    return tuple(finding for k, finding in enumerate(findings) if finding not in findings[:k])


def first_of_each_kind(findings: Iterable[Finding]) -> list[tuple[Finding, int]]:
    """First finding of each group, and the number of others in the group."""
    groups: dict[str, list[Finding]] = {}
    for finding in findings:
        groups.setdefault(finding.group, []).append(finding)
    return [(group[0], len(group) - 1) for group in groups.values()]


def failed(kind: str, error: CurveUpsError) -> Finding:
    """Reason of this kind that quotes an error."""
    if error.finding is not None:
        return Finding(kind, error.finding.tiles, {"error": error.finding})
    return Finding(kind, (), {"error": error.what + (f" ({error.remedy})" if error.remedy else "")})


def refused(error: CurveUpsError) -> Finding:
    """Finding with an error's text, place and remedy."""
    return Finding.about("refused", error.tiles, what=error.what, where=error.where, remedy=error.remedy)


def require_no_error(findings: Sequence[Any], where: str) -> tuple[Finding, ...]:
    """Values of native findings. Raises the first that is an error."""
    for finding in findings:
        if finding.is_error:
            raise refusal(Finding.of(finding), where)
    return all_of(findings)


def refusal(finding: Finding, where: str) -> CurveUpsError:
    """Error of a finding, which names its tiles, or faces of the input, beside `where`."""
    faces = finding.figures.get("faces", ())
    rows = f"{_Shown(finding.tiles, ENGLISH):6}" if finding.tiles else f"{_Shown(faces, ENGLISH):#6}"
    place = (where, f"faces {rows}" if faces else rows)
    return CurveUpsError(finding.sentence(), ", ".join(part for part in place if part), finding.remedy(),
                         finding=finding)


def _figure(figure: Any) -> Any:
    if isinstance(figure, list):
        return tuple(map(_figure, figure))
    return figure if isinstance(figure, (int, float, str)) else Finding.of(figure)


def _plain(figure: Any, of: Callable[["Finding"], Any] = str) -> Any:
    """Figure as JSON; of: converts findings."""
    if isinstance(figure, tuple):
        return [_plain(item, of) for item in figure]
    return of(figure) if isinstance(figure, Finding) else figure


def _read(figure: Any) -> Any:
    if isinstance(figure, list):
        return tuple(map(_read, figure))
    return Finding.read(figure) if isinstance(figure, dict) else figure
