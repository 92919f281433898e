# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keeps a design with its results and their keys, saves them, and works on a thread."""
