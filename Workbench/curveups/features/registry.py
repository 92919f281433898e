# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proxies by stored type, for documents that a FreeCAD without this workbench has saved: it drops proxies,
and keeps the property CurveUpsType."""

from __future__ import annotations

from typing import Any

from .bodies import BodiesProxy
from .cuts import CutsProxy
from .design import DesignProxy
from .layout import LayoutProxy
from .proxy import Proxy, designs, show, type_of
from .target import TYPE as TARGET, notice
from .verification import VerificationProxy

TYPES: dict[str, type[Proxy]] = {proxy.TYPE: proxy for proxy in (
    DesignProxy, CutsProxy, LayoutProxy, VerificationProxy, BodiesProxy)}


def opened(document: Any) -> None:
    """Attaches lost proxies, shows all objects of ours, and compares targets with their sources."""
    lost = [obj for obj in document.Objects if type_of(obj) in TYPES and obj.Proxy is None]
    for obj in lost:
        TYPES[type_of(obj)](obj)
    for obj in document.Objects:
        if type_of(obj) == TARGET:
            notice(obj)
        show(obj)
    for design in designs(document) if lost else ():
        design.Proxy.refresh(design)
