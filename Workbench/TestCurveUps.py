# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests whether the workbench works in this FreeCAD: `freecad -t TestCurveUps`, or Test framework in the
window. Some seconds; tools/test of the sources is thorough."""

from __future__ import annotations

import tempfile
import unittest
from pathlib import Path
from typing import Any

import FreeCAD

ROOT = Path(__file__).resolve().parents[1]


class TestCurveUps(unittest.TestCase):
    """Small dome from target to print files, in a document."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.document = FreeCAD.newDocument("TestCurveUps", hidden=True, temp=True)
        self.addCleanup(lambda: FreeCAD.closeDocument(self.document.Name))

    def design(self) -> Any:
        """A design of a built-in target of some 150 tiles, solved."""
        from curveups.features.document import new_design, project_of, take

        design = new_design(self.document, "half-sphere")
        design.L = 15
        self.document.recompute()
        take(design, project_of(design).run(("figures", "verification")))
        self.document.recompute()
        return design

    def test_native_module(self) -> None:
        """The native module is there, for this Python and of this version."""
        from curveups import __version__
        from curveups.base.native import problem

        self.assertIsNone(problem())
        self.assertEqual(FreeCAD.Metadata(str(ROOT / "package.xml")).Version, __version__)

    def test_design(self) -> None:
        """A target becomes a valid design, which its document keeps."""
        design = self.design()
        self.assertEqual(design.Verdict, "valid", list(design.Reasons))
        tiles, weakest = design.TileCount, design.MinNormalForce
        self.assertGreater(tiles, 20)
        self.assertGreater(float(weakest), 0)
        kept = str(self.folder / "kept.FCStd")
        self.document.saveCopy(kept)
        again = FreeCAD.openDocument(kept, hidden=True)
        try:
            found = again.getObject(design.Name)
            self.assertEqual((found.TileCount, found.MinNormalForce, found.Verdict),
                             (tiles, weakest, "valid"))
        finally:
            FreeCAD.closeDocument(again.Name)

    def test_stale_results_say_so(self) -> None:
        """A parameter that the layout was not made with takes the verdict away."""
        design = self.design()
        design.Tau = 2.5
        self.document.recompute()
        self.assertNotEqual(design.Verdict, "valid")
        self.assertTrue(list(design.Reasons))
