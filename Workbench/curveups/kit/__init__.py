# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fabrication kit: all between a valid design and a finished shell."""
