# SPDX-License-Identifier: LGPL-2.1-or-later
"""CurveUps: curvy shells that are printed flat and pulled into shape by pre-stretched membranes."""

__version__ = "0.1.0"
