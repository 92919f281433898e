# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything that needs FreeCAD's window: commands, panels, the overlay, views of the tree."""
