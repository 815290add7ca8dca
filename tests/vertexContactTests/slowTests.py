#!/usr/bin/env python3
"""The tests that tests/Alltest -quick leaves out: functions that take more than
a second.

    tests/vertexContactTests/slowTests.py .build/tests/pytest.xml

writes slowTests.txt beside this file, from a report of pytest in JUnit's format
of a whole run."""

import sys
from pathlib import Path
from xml.etree import ElementTree

FILE = Path(__file__).with_suffix(".txt")
LIMIT = 1   # [s]


def names():
    """file::function of all slow tests."""
    return set(FILE.read_text().split())


if __name__ == "__main__":
    slow = set()
    for case in ElementTree.parse(sys.argv[1]).iter("testcase"):
        if float(case.get("time")) > LIMIT:
            file = case.get("classname").replace(".", "/")
            slow.add(f"{file}.py::{case.get('name').split('[')[0]}")
    FILE.write_text("\n".join(sorted(slow)) + "\n")
