# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels, each with its file in resources/ui. Only loaded with a window."""
