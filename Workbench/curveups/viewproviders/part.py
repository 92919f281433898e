# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of the objects below a Design."""

from ..window.viewproviders.part import CutsView, LayoutView, VerificationView  # noqa: F401
