# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors, findings, the native module, parameters, progress and output folders, for all other rooms."""
