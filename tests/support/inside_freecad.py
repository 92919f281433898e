# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs in FreeCAD's own process (freecad_process.py starts it): the tests of a file by pytest, or
one function.

Every request and answer is a message on the channel. FreeCAD ends with the channel.
"""

from __future__ import annotations

import importlib.util
import os
import sys
import traceback
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, Callable

sys.path.insert(0, str(Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import pytest  # noqa: E402
from freecad_process import own_name  # noqa: E402
from freecad_tests import placeholders  # noqa: E402


class Serving:
    """A pytest plugin: runs the tests that are asked for, one after another, and sends their reports."""

    def __init__(self, channel: Connection) -> None:
        self._channel = channel
        self._config: Any = None
        self._broken: list[str] = []

    def pytest_configure(self, config: Any) -> None:
        self._config = config

    def pytest_collectreport(self, report: Any) -> None:
        if report.failed:
            self._broken.append(str(report.longrepr))

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: Any) -> bool:
        items = {own_name(item.nodeid): item for item in session.items}
        while (request := self._channel.recv()) is not None:
            name, following = request
            if name in items:
                self._config.hook.pytest_runtest_protocol(item=items[name], nextitem=items.get(following))
                self._channel.send(("done", None))
            else:
                self._channel.send(("broken", "\n".join(self._broken) or f"{name} is not in this file"))
        return True

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_makereport(self, call: Any) -> Any:
        """Whatever FreeCAD reports in place of raising it fails the test, too."""
        made = yield
        report = made.get_result()
        said = "\n".join(text for title, text in report.sections
                         if title.startswith("Captured std") and title.endswith(call.when))
        if report.passed and "Traceback" in said:
            report.outcome, report.longrepr = "failed", "a traceback in what FreeCAD printed"

    def pytest_runtest_logreport(self, report: Any) -> None:
        self._channel.send(("report", self._config.hook.pytest_report_to_serializable(
            config=self._config, report=report)))


def run_tests(channel: Connection, path: str, root: str, folder: str) -> None:
    options = ["-p", "no:cacheprovider", "-p", "no:xdist", "--rootdir", root, "--basetemp", folder]
    pytest.main([path, "-q", *options], plugins=[Serving(channel)])


def call(channel: Connection, path: str, name: str, arguments: tuple[Any, ...]) -> None:
    """A function of a file, as it is without pytest."""
    try:
        spec = importlib.util.spec_from_file_location("called", path)
        assert spec and spec.loader
        module = importlib.util.module_from_spec(spec)
        with placeholders({"curveups"} if importlib.util.find_spec("curveups") is None else set()):
            spec.loader.exec_module(module)
        channel.send(("done", getattr(module, name)(*arguments)))
    except BaseException:
        channel.send(("broken", traceback.format_exc()))


def serve() -> None:
    jobs: dict[str, Callable[..., None]] = {"tests": run_tests, "call": call}
    channel = Connection(int(os.environ["CURVEUPS_CHANNEL"]))
    os.set_inheritable(channel.fileno(), False)
    try:
        while True:
            kind, *arguments = channel.recv()
            jobs[kind](channel, *arguments)
    except EOFError:
        pass
    finally:
        sys.stdout.flush()
        os._exit(0)


# FreeCAD runs this file as a program or imports it, with or without a window.
if FreeCAD.GuiUp:
    from PySide import QtCore

    QtCore.QTimer.singleShot(500, serve)  # once the window stands
else:
    serve()
