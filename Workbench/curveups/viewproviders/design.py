# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of Design objects."""

from ..window.viewproviders.design import DesignView  # noqa: F401
