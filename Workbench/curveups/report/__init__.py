# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run found: report.json, and report.html with its pictures."""
