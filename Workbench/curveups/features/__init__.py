# SPDX-License-Identifier: LGPL-2.1-or-later
"""Defines the objects of a FreeCAD document. This is App code: nothing here imports Gui."""
