# SPDX-License-Identifier: LGPL-2.1-or-later
"""What speaks for or against a target, a design or its print, as a value: a reason, a warning, an advice.
Sentences are made of it here alone, of the templates in sentences.py, in any language."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, ClassVar, Iterable, Mapping, Sequence

from .errors import CurveUpsError, tile_name
from .sentences import MORE, SENTENCES, WORDS


class Value:
    """Base of frozen dataclasses that can be saved: they are known by their name to whoever saves them."""

    known: ClassVar[dict[str, type]] = {}

    def __init_subclass__(cls) -> None:
        Value.known[cls.__name__] = cls


@dataclass(frozen=True)
class Style:
    """How a sentence is written. `words`: a template in another language; `tile`: a row of F by its name;
    `plain`: text as it stands in the sentence (escaped, say); `quantity`: a number, how Python writes it, and
    its unit."""

    words: Callable[[str], str] = str
    tile: Callable[[int], str] = tile_name
    plain: Callable[[str], str] = str
    quantity: Callable[[float, str, str], str] = lambda number, how, unit: f"{number:{how}} {unit}"


ENGLISH = Style()


@dataclass(frozen=True)
class Finding(Value):
    """`kind`: of SENTENCES; before its first dot stands what report.json calls it. `tiles`: that it is about
    (rows of F, ascending); none: all of the design. `figures`: that its sentence names: numbers, words, rows
    (of F, or of a file's faces or vertices), pairs of rows of F, other findings."""

    kind: str
    tiles: tuple[int, ...] = ()
    figures: Mapping[str, Any] = field(default_factory=dict)

    @classmethod
    def of(cls, found: Any) -> "Finding":
        """The value of a native Finding."""
        return cls(found.kind, tuple(found.tiles),
                   {name: _figure(figure) for name, figure in found.figures.items()})

    @classmethod
    def about(cls, kind: str, tiles: Iterable[int] = (), **figures: Any) -> "Finding":
        """With figures by their names."""
        return cls(kind, tuple(sorted({int(tile) for tile in tiles})), figures)

    @classmethod
    def read(cls, data: Any) -> "Finding":
        """Finding read from what `data` gave. Raises LookupError, TypeError or ValueError where damaged."""
        return cls(str(data["kind"]), tuple(map(int, data["tiles"])),
                   {str(name): _read(figure) for name, figure in dict(data["figures"]).items()})

    @property
    def data(self) -> dict[str, Any]:
        """For JSON."""
        return {"kind": self.kind, "tiles": self.tiles,
                "figures": {name: _plain(figure, lambda finding: finding.data)
                            for name, figure in self.figures.items()}}

    @property
    def group(self) -> str:
        """What report.json calls it."""
        return self.kind.partition(".")[0]

    def __str__(self) -> str:
        return self.sentence()

    def sentence(self, style: Style = ENGLISH) -> str:
        """What is found."""
        return self._write(0, style)

    def remedy(self, style: Style = ENGLISH) -> str:
        """What to do about it; empty where that is not known."""
        return self._write(1, style)

    def concerns(self, tiles: Iterable[int]) -> bool:
        """Whether it is about one of these tiles, or about all."""
        return not self.tiles or not set(self.tiles).isdisjoint(tiles)

    def entry(self) -> dict[str, Any]:
        """As report.json has it."""
        remedy, figures = self.remedy(), {name: _plain(figure) for name, figure in self.figures.items()}
        return {**figures, "what": str(self), "kind": self.group, **({"remedy": remedy} if remedy else {}),
                "tiles": list(self.tiles)}

    def _write(self, part: int, style: Style) -> str:
        texts = SENTENCES.get(self.kind, (self.kind, ""))
        try:
            return style.plain(style.words(texts[part])).format_map(
                {name: _Shown(figure, style) for name, figure in self.figures.items()}) if texts[part] else ""
        except (ArithmeticError, LookupError, TypeError, ValueError):
            return style.plain(self.kind)  # of a document that was damaged


class _Shown:
    """A figure in a sentence. After the colon of its place stands how: of numbers as Python has it, and a
    unit; of rows how many are named, "#" before that of no tiles; of findings what stands between them."""

    def __init__(self, figure: Any, style: Style):
        self._figure, self._style = figure, style

    def __format__(self, how: str) -> str:
        figure, style = self._figure, self._style
        if isinstance(figure, Finding):
            return figure.sentence(style)
        if isinstance(figure, str):
            sentence = " " in figure  # of an error; a name has no spaces
            return style.plain(style.words(figure) if sentence or figure in WORDS else figure)
        if not isinstance(figure, tuple):
            number, _, unit = how.partition(" ")
            return style.quantity(figure, number, unit) if unit else format(figure, number)
        if figure and isinstance(figure[0], Finding):
            return style.plain(style.words(how)).join(one.sentence(style) for one in figure)
        most = int(how.lstrip("#") or len(figure))
        names = ", ".join("-".join(map(style.tile, row)) if isinstance(row, tuple)
                          else str(row + 1) if how.startswith("#") else style.tile(row)
                          for row in figure[:most])
        left = len(figure) - most
        return names + (style.plain(style.words(MORE)).format(count=left) if left > 0 else "")


def all_of(found: Iterable[Any]) -> tuple[Finding, ...]:
    """The values of native findings."""
    return tuple(map(Finding.of, found))


def unique(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """Each once: several results may give the same one."""
    found: list[Finding] = []
    for one in findings:
        if one not in found:
            found.append(one)
    return tuple(found)


def first_of_each_kind(findings: Iterable[Finding]) -> list[tuple[Finding, int]]:
    """The first of each group, and how many others of that group there are."""
    groups: dict[str, list[Finding]] = {}
    for one in findings:
        groups.setdefault(one.group, []).append(one)
    return [(group[0], len(group) - 1) for group in groups.values()]


def failed(kind: str, error: CurveUpsError) -> Finding:
    """An error as a reason."""
    if error.finding is not None:
        return Finding(kind, error.finding.tiles, {"error": error.finding})
    return Finding(kind, (), {"error": error.what + (f" ({error.remedy})" if error.remedy else "")})


def refused(error: CurveUpsError) -> Finding:
    """An error whole: what, where and remedy."""
    return Finding.about("refused", error.tiles, what=error.what, where=error.where, remedy=error.remedy)


def settle(findings: Sequence[Any], where: str) -> tuple[Finding, ...]:
    """Raises the first error among native findings; all others."""
    for one in findings:
        if one.is_error:
            raise refusal(Finding.of(one), where)
    return all_of(findings)


def refusal(found: Finding, where: str) -> CurveUpsError:
    """The error that a finding is, with the tiles, or the faces of the input, in its place."""
    faces = found.figures.get("faces", ())
    rows = f"{_Shown(found.tiles, ENGLISH):6}" if found.tiles else f"{_Shown(faces, ENGLISH):#6}"
    place = (where, f"faces {rows}" if faces else rows)
    return CurveUpsError(found.sentence(), ", ".join(part for part in place if part), found.remedy(),
                         finding=found)


def _figure(figure: Any) -> Any:
    if isinstance(figure, list):
        return tuple(map(_figure, figure))
    return figure if isinstance(figure, (int, float, str)) else Finding.of(figure)


def _plain(figure: Any, of: Callable[["Finding"], Any] = str) -> Any:
    """For JSON; of: what stands for a finding."""
    if isinstance(figure, tuple):
        return [_plain(one, of) for one in figure]
    return of(figure) if isinstance(figure, Finding) else figure


def _read(figure: Any) -> Any:
    if isinstance(figure, list):
        return tuple(map(_read, figure))
    return Finding.read(figure) if isinstance(figure, dict) else figure
