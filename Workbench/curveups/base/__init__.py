# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every other room uses: errors, the native module, progress, output folders, the machine, Qt."""
