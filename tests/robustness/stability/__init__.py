"""The stability map: scenes that go to an extreme, and how a run of one is
judged."""

import sys
from pathlib import Path

root = Path(__file__).resolve().parents[3]
for folder in root/"tests"/"verification", root/"tutorials":
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))
