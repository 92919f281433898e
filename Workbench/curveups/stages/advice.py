# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would help: the one room that turns what stages found by trying into advice."""

from __future__ import annotations

from typing import Any, Iterable, Iterator, Mapping, Optional, Sequence

from ..base.findings import Finding
from ..base.native import native

Sizes = Sequence[tuple[str, float]]  # parameters by name, with values that do together
_GAP = "gap"  # of repair's obstacles: all others are pins'


def suggested(what: Finding) -> Finding:
    """An advice among the reasons of a verdict."""
    return Finding("suggested", what.tiles, {"what_to_do": what})


def against(obstacles: Iterable[str]) -> tuple[Finding, ...]:
    """What would help in general where repair met these; "": contacts that nothing holds stay weak."""
    met = set(obstacles)
    kinds = {"advice.cut_gaps": _GAP in met, "advice.pin_room": bool(met - {_GAP, ""}),
             "advice.pull": "" in met}
    return tuple(Finding(kind) for kind, there in kinds.items() if there)


def other_parameters(design: Any, small: Iterable[int], blocked: Iterable[Mapping[str, Any]],
                     weak: Sequence[tuple[int, int]]) -> tuple[Finding, ...]:
    """Values of parameters for pins without room (small: tiles; blocked: contacts, as Repair has them) and
    for membranes without tension (weak: contacts)."""
    pins = {*small, *(tile for contact in blocked if contact["obstacle"] not in ("", _GAP)
                      for tile in contact["held"])}
    if not pins and not weak:
        return ()
    values = native.find_remedies(design, sorted(pins), list(weak))
    both = values.H_body is not None
    return tuple(Finding.about(f"advice.{name}_too" if name == "L" and both else f"advice.{name}",
                               value=getattr(values, name), set=design.parameters.get(name))
                 for name in ("H_body", "L", "tau") if getattr(values, name) is not None)


def as_sizes(sizes: Sizes) -> Finding:
    """Sizes that do, one or two."""
    if len(sizes) == 1:
        return Finding.about("size", name=sizes[0][0], value=sizes[0][1])
    return Finding("size.both", (), dict(sizes))


def tried_sizes(sizes: Optional[Sizes], tried: int) -> tuple[Finding, ...]:
    """After designs were made with other sizes."""
    if sizes is None:
        return (Finding.about("advice.none_tried", tried=tried),) if tried else ()
    return (suggested(Finding.about("advice.tried", sizes=tuple(
        Finding.about("size", name=name, value=value) for name, value in sizes))),)


def checked_sizes(options: Sequence[Sizes]) -> tuple[Finding, ...]:
    """With which the estimates of check find nothing in the way."""
    known = tuple(map(as_sizes, options))
    return (suggested(Finding.about("advice.checked", sizes=known)),) if known else ()


def other_sizes(options: Sequence[Sizes], tried: int, mending: Optional[float], mended: bool) -> str:
    """For an error: each of the options does; mending: mm by which mend=on would move vertices; mended: it is
    on, and sizes were tried without it."""
    sizes = (Finding.about("advice.sizes", sizes=tuple(map(as_sizes, options)), tried=tried) if options
             else Finding.about("advice.no_sizes", tried=tried))
    moved = [Finding.about("advice.mend", moved=mending)] if mending is not None else []
    more = [Finding("advice.auto")] if mended else []
    return "; ".join(map(str, (sizes, *moved, *more)))


def of_check(sizes: Any, L: float, H_body: float) -> Iterator[Finding]:
    """On sizes (Recommendation) that would do for a target, and on mending."""
    if sizes.L is not None:
        low, high = sizes.L
        if low < high:
            yield Finding.about("check.L", H_body=H_body, low=low, high=high)
        elif low != L:
            yield Finding.about("check.L_alone", H_body=H_body, L=low)
    elif any(one[1] == H_body and not one[-1] for one in sizes.tried):
        yield Finding.about("check.no_L", H_body=H_body)
    if sizes.H_body is None:
        yield Finding.about("check.no_H_body", L=L)
    else:
        kind = ("check.H_body_alone" if not sizes.as_set else
                "check.H_body_more" if sizes.H_body >= sizes.thickest else "check.H_body")
        yield Finding.about(kind, L=L, H_body=sizes.H_body)
    if sizes.H_pin is None:
        yield Finding.about("check.no_H_pin", L=L, H_body=H_body)
    else:
        kind = "check.H_pin_down" if sizes.as_set else "check.H_pin"
        yield Finding.about(kind, L=L, H_body=H_body, H_pin=sizes.H_pin)
    if sizes.together is not None:
        yield Finding.about("check.together", L=L, H_body=sizes.together[0], H_pin=sizes.together[1])
    mends = sizes.mending is not None
    if mends:
        yield Finding.about("check.mend", moved=sizes.mending)
    for name, reasons in sizes.beyond.items():
        yield Finding.about("check.beyond", sizes=_named(sizes, name), reasons=reasons)
    if sizes.estimated and (sizes.L or sizes.H_body or sizes.H_pin or sizes.together or mends):
        yield Finding("check.estimated")


def _named(sizes: Any, name: str) -> Finding:
    """What a Recommendation has by this name."""
    if name == "mend":
        return Finding("size.mend")
    if name == "together":
        return as_sizes(tuple(zip(("H_body", "H_pin"), sizes.together)))
    return as_sizes(((name, sizes.L[0] if name == "L" else getattr(sizes, name)),))
