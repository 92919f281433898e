# SPDX-License-Identifier: LGPL-2.1-or-later
"""How document objects look in the tree."""
