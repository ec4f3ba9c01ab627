"""The deliberate bugs of tests/mutation fit the sources."""

import pathlib
import sys

SOURCE = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(SOURCE / "tests" / "mutation"))
from breaks import BREAKS  # noqa: E402


def test_each_bug_has_its_place():
    stale = [bug for bug in BREAKS if (SOURCE / bug.file).read_text(encoding="utf-8").count(bug.old) != 1]
    assert len(BREAKS) >= 40 and stale == []
