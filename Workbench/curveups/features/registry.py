# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which proxy belongs to which stored type; attaches those that a document has lost.

A FreeCAD without this workbench drops all proxies when it saves, and some refuse to load proxies of
modules that they do not know. What an object is stays in its property CurveUpsType.
"""

from __future__ import annotations

from typing import Any

from .bodies import BodiesProxy
from .cuts import CutsProxy
from .design import DesignProxy
from .layout import LayoutProxy
from .proxy import Proxy, designs, show, type_of
from .target import TYPE as TARGET, make_target, notice
from .verification import VerificationProxy

TYPES: dict[str, type[Proxy]] = {proxy.TYPE: proxy for proxy in (
    DesignProxy, CutsProxy, LayoutProxy, VerificationProxy, BodiesProxy)}


def is_lost(obj: Any) -> bool:
    """Whether `restore` has something to do for an object."""
    return _lacks_proxy(obj)


def restore(document: Any) -> list[Any]:
    """Attaches lost proxies; the objects that were mended."""
    mended = []
    for obj in document.Objects:
        if type_of(obj) == TARGET:
            make_target(obj)
            notice(obj)
        if _lacks_proxy(obj):
            TYPES[type_of(obj)](obj)
            mended.append(obj)
        show(obj)
    for design in designs(document) if mended else ():
        design.Proxy.refresh(design)
    return mended


def _lacks_proxy(obj: Any) -> bool:
    proxy = TYPES.get(type_of(obj))
    return proxy is not None and not isinstance(getattr(obj, "Proxy", None), proxy)
