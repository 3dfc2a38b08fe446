# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""The example of Python runs as users run it, and writes what it says."""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class ExampleTest(unittest.TestCase):
    def test_tissue_statistics_prints_layers_and_writes_files(self):
        path = os.pathsep.join([str(ROOT / "wrapping" / "python"), *filter(None, [os.environ.get("PYTHONPATH")])])
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run(
                [sys.executable, "-B", str(ROOT / "examples" / "tissue_statistics.py"), folder],
                env={**os.environ, "PYTHONPATH": path, "MPLCONFIGDIR": folder},
                capture_output=True,
                text=True,
            )
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("TissueMesh(120 cells", run.stdout)
            rows = re.findall(r"^ +(\d+) +(\d+) +[\d.]+ +0\.\d+ +[\d.]+$", run.stdout, re.M)
            self.assertEqual([row[0] for row in rows][:2], ["1", "2"])
            self.assertEqual(sum(int(row[1]) for row in rows), 120)
            for module, file in (("meshio", "walls.vtu"), ("matplotlib", "tissue.png")):
                if importlib.util.find_spec(module):
                    self.assertGreater((pathlib.Path(folder) / file).stat().st_size, 10000)


if __name__ == "__main__":
    unittest.main()
