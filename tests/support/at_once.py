# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pytest plugin: says each failure when it happens. pytest itself says all of them at the end."""

from __future__ import annotations

import pytest


class AtOnce:
    def __init__(self, config: pytest.Config) -> None:
        self._config = config

    @pytest.hookimpl(trylast=True)
    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed:
            terminal = self._config.pluginmanager.getplugin("terminalreporter")  # not there at first
            terminal.ensure_newline()
            terminal.section(report.nodeid, "_")
            terminal.line(report.longreprtext)
            for title, text in report.sections:
                terminal.line(f"{title}:\n{text[-3000:]}")


def pytest_configure(config: pytest.Config) -> None:
    if not hasattr(config, "workerinput"):  # that of xdist's processes goes through the first one
        config.pluginmanager.register(AtOnce(config))
