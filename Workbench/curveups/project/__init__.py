# SPDX-License-Identifier: LGPL-2.1-or-later
"""A design with its results, keyed by what they were made from; saving them; working on a thread."""
