"""Floating-point numbers are compared by tests/fixtures/tolerance.hpp. Three claims:

 1. no test uses doctest::Approx: its tolerance is one of 1 + |x|, so that small quantities in SI units pass whatever they are;
 2. each comparison stands alone in a CHECK, where shift_expected.py can see it fail;
 3. largest deviations are kept by fixtures::larger(), since std::max() and std::fmax() drop a NaN.

    comparisons.py ROOT
"""

import re
import sys
from pathlib import Path

from shift_expected import code_of, comparisons_in

APPROX = re.compile(r"\bApprox\b")
MAXIMUM = re.compile(r"([\w.\[\]]+) = std::f?max\(\1,")


def main():
    root = Path(sys.argv[1])
    comparisons, faults = comparisons_in(root)
    for path in sorted((root / "tests").rglob("*.?pp")):
        for number, line in enumerate(code_of(path).splitlines(), 1):
            if APPROX.search(line):
                faults.append(f"{path.relative_to(root)}:{number}: compare with fixtures::relative or fixtures::absolute (tests/fixtures/tolerance.hpp)")
            if MAXIMUM.search(line):
                faults.append(f"{path.relative_to(root)}:{number}: keep the maximum by fixtures::larger() (tests/fixtures/larger.hpp), which does not drop a NaN")
    assert len(comparisons) > 100, f"there are hardly any comparisons in {root}"
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
