# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pytest plugin: tests that are marked `freecad` run inside of a FreeCAD, one process a file.

pytest collects them as any others, with placeholders for the modules that only FreeCAD has. Then a FreeCAD
(freecad_process.py) runs each and sends its reports. If FreeCAD crashes or hangs, the present test fails with
the end of FreeCAD's log, and the next test begins a new process.
"""

from __future__ import annotations

import importlib.abc
import importlib.machinery
import sys
import types
from contextlib import contextmanager
from typing import Any, Iterator, Optional
from unittest.mock import MagicMock

import pytest
from freecad_process import Ended, FreeCADProcess, has_display, own_name

INSIDE = "FreeCAD" in sys.modules  # this is the pytest in FreeCAD
# Modules that need a FreeCAD around them, and ours that import these.
ONLY_IN_FREECAD = {"FreeCAD", "FreeCADGui", "Part", "Mesh", "PySide", "pivy", "curveups", "robot"}


class _Placeholder(types.ModuleType):
    __path__: list[str] = []

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return MagicMock(name=name)


class _Placeholders(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    def __init__(self, names: set[str]) -> None:
        self._names = names

    def find_spec(self, name: str, path: Any, target: Any = None) -> Any:
        if name.partition(".")[0] in self._names:
            return importlib.machinery.ModuleSpec(name, self, is_package=True)
        return None

    def create_module(self, spec: Any) -> types.ModuleType:
        return _Placeholder(spec.name)

    def exec_module(self, module: types.ModuleType) -> None:
        pass


@contextmanager
def placeholders(names: set[str]) -> Iterator[None]:
    """Let imports of these packages give objects with any attribute."""

    def taken() -> dict[str, types.ModuleType]:
        return {name: sys.modules.pop(name) for name in list(sys.modules)
                if name.partition(".")[0] in names}

    kept, finder = taken(), _Placeholders(names)
    sys.meta_path.insert(0, finder)
    try:
        yield
    finally:
        sys.meta_path.remove(finder)
        taken()
        sys.modules.update(kept)


class _Module(pytest.Module):
    def _getobj(self) -> Any:
        with placeholders(ONLY_IN_FREECAD):
            return super()._getobj()


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "freecad(home='workbench', window=False, timeout=300): in FreeCAD")
    config.addinivalue_line("markers", "all: a long test, which `tools/test --all` runs")
    if not INSIDE:
        config.pluginmanager.register(_Asking(config), "asking-freecad")


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makemodule(module_path: Any, parent: Any) -> Optional[pytest.Module]:
    return None if INSIDE else _Module.from_parent(parent, path=module_path)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    if not has_display():
        for item in items:
            if _options(item).get("window"):
                item.add_marker(pytest.mark.skip(reason="there is no xvfb-run or no xdotool"))


def _options(item: pytest.Item) -> dict[str, Any]:
    """Options of a test from all its marks; the nearest counts most."""
    options: dict[str, Any] = {}
    for mark in reversed(list(item.iter_markers("freecad"))):
        options = {"home": "workbench", "window": False, "timeout": 300, **options, **mark.kwargs}
    return options


class _Asking:
    """The FreeCAD that runs the tests of a file."""

    def __init__(self, config: pytest.Config) -> None:
        self._config = config
        self._process: Optional[FreeCADProcess] = None
        self._folder: Any = None

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtest_protocol(self, item: pytest.Item, nextitem: Optional[pytest.Item]) -> Optional[bool]:
        options = _options(item)
        if not options or (options["window"] and not has_display()):
            return None
        hook = item.ihook
        hook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
        stays = nextitem is not None and self._needs(nextitem) == self._needs(item)
        phases = []
        try:
            process = self._process or self._start(item, options)
            process.send((own_name(item.nodeid), own_name(nextitem.nodeid) if nextitem and stays else None))
            while (answer := process.receive(options["timeout"]))[0] == "report":
                report = hook.pytest_report_from_serializable(config=self._config, data=answer[1])
                report.nodeid = item.nodeid
                phases.append(report.when)
                hook.pytest_runtest_logreport(report=report)
            wrong = answer[1]
        except Ended as error:
            wrong, stays = str(error), False
        if wrong:
            hook.pytest_runtest_logreport(report=pytest.TestReport(
                item.nodeid, item.location, dict.fromkeys(item.keywords, 1), "failed", wrong,
                "teardown" if "call" in phases else "call"))
        if not stays:
            self._end()
        hook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
        return True

    def pytest_sessionfinish(self) -> None:
        self._end()

    def _needs(self, item: pytest.Item) -> tuple[Any, ...]:
        options = _options(item)
        return item.path, options.get("home"), options.get("window")

    def _start(self, item: pytest.Item, options: dict[str, Any]) -> FreeCADProcess:
        self._folder = self._config._tmp_path_factory.mktemp(item.path.stem)  # type: ignore[attr-defined]
        self._process = FreeCADProcess(self._folder, options["home"], options["window"])
        self._process.send(("tests", str(item.path), str(self._config.rootpath), str(self._folder / "tests")))
        return self._process

    def _end(self) -> None:
        if self._process is not None:
            self._process.end()
        self._process = None
