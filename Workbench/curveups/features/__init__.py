# SPDX-License-Identifier: LGPL-2.1-or-later
"""The objects of a FreeCAD document. App code only: nothing here imports Gui."""
