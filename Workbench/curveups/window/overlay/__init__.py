# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawing of a Design in the 3D view, light enough for thousands of tiles, with values as colours.

A Scene has the values, without Coin; a Figure draws it in Coin, without a document.
"""
