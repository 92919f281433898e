# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports what a run found: report.json, and report.html with its pictures."""
