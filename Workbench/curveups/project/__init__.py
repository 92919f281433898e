# SPDX-License-Identifier: LGPL-2.1-or-later
"""A design with its results and their keys, their storage, and work on a thread."""
