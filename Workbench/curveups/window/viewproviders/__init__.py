# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows document objects in the tree."""
