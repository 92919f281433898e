# SPDX-License-Identifier: LGPL-2.1-or-later
"""The overlay: how a Design is drawn in the 3D view, as light as it can be, with figures as colours.

What is drawn is a Scene (values, no Coin), drawn by a Figure (Coin, no document).
"""
