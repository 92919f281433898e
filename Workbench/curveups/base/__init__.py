# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every other room uses this one: errors, the native module, progress, output folders, the machine, Qt."""
