# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pytest plugin: each failure when it happens, and at the end the seconds of every file."""

from __future__ import annotations

from collections import defaultdict

import pytest


class AtOnce:
    def __init__(self, config: pytest.Config) -> None:
        self._config = config
        self._seconds: dict[str, float] = defaultdict(float)

    @pytest.hookimpl(trylast=True)
    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self._seconds[report.nodeid.partition("::")[0]] += report.duration
        if report.failed:
            terminal = self._config.pluginmanager.getplugin("terminalreporter")  # not there at first
            terminal.ensure_newline()
            terminal.section(report.nodeid, "_")
            terminal.line(report.longreprtext)
            for title, text in report.sections:
                terminal.line(f"{title}:\n{text[-3000:]}")

    def pytest_terminal_summary(self) -> None:
        terminal = self._config.pluginmanager.getplugin("terminalreporter")
        terminal.section("seconds per file")
        for file, seconds in sorted(self._seconds.items(), key=lambda row: -row[1]):
            terminal.line(f"{seconds:7.1f} s {file}")


def pytest_configure(config: pytest.Config) -> None:
    if not hasattr(config, "workerinput"):  # that of xdist's processes goes through the first one
        config.pluginmanager.register(AtOnce(config))
