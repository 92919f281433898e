# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pytest plugin: says each failure when it happens. pytest itself says all of them at the end."""

from __future__ import annotations

import pytest


class AtOnce:
    def __init__(self, config: pytest.Config) -> None:
        self._terminal = config.pluginmanager.getplugin("terminalreporter")

    @pytest.hookimpl(trylast=True)
    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed:
            self._terminal.ensure_newline()
            self._terminal.section(report.nodeid, "_")
            self._terminal.line(report.longreprtext)
            for title, text in report.sections:
                self._terminal.line(f"{title}:\n{text[-3000:]}")


def pytest_configure(config: pytest.Config) -> None:
    if not hasattr(config, "workerinput"):  # that of xdist's processes goes through the first one
        config.pluginmanager.register(AtOnce(config))
