# SPDX-License-Identifier: LGPL-2.1-or-later
"""Of Design objects."""

from ..window.viewproviders.design import DesignView  # noqa: F401
