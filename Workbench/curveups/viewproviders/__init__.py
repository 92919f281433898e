# SPDX-License-Identifier: LGPL-2.1-or-later
"""The names under which documents of 0.1.0 store their views; window/viewproviders has them."""
