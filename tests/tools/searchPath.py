"""The folders in which Python finds what tests, benchmarks and tutorials share.
To import this module is enough. pytest does so in conftest.py; a script that is
run by itself says before its other imports

    sys.path.insert(0, str(Path(__file__).resolve().parents[1]/"tools"))
    import searchPath

with the number of folders up to tests/.
"""

import sys
from pathlib import Path

root = Path(__file__).resolve().parents[2]

FOLDERS = (
    "tests/tools",
    "tests/verification/publishedContact",
    "tests/robustness",                     # the package stability
    "tests/releases",
    "tests/benchmark/trade",
    "tests/benchmark/peers/calculix",
    "tutorials",
    "tutorials/dropTest",
    "tutorials/formingTool",
    "tutorials/hertzContact",
    "tutorials/hundredDiscs",
    "tutorials/newtonsCradle",
    "tutorials/pressFit",
    "tutorials/shallowIroning",
    "tutorials/twoBarImpact",
)

# In front, for packages may have modules of these names
sys.path[:0] = [str(root/folder) for folder in FOLDERS
                 if str(root/folder) not in sys.path]
