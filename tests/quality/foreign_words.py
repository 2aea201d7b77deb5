"""Nothing in the repository names a place on somebody's machine, or work that was put off.

    foreign_words.py ROOT
"""

import os
import re
import sys
from pathlib import Path

NOT_OURS = {".git", "build", "results", "node_modules", "__pycache__"}

# written so that this file does not hold them itself
PLACES = re.compile("|".join(["/wo" + "rk/", "/ro" + "ot/", "/ho" + "me/", "/tmp/" + "bash", "/Us" + "ers/"]))
PUT_OFF = re.compile(r"\b(TO" + "DO|FIX" + r"ME|XX" + r"X)\b")


def files_of(root):
    for folder, folders, names in os.walk(root):
        folders[:] = [name for name in folders if name not in NOT_OURS]
        for name in names:
            if name != ".git":  # a file where the checkout is a second one of the same repository
                yield Path(folder) / name


def main():
    root = Path(sys.argv[1])
    faults, read = [], 0
    for path in files_of(root):
        try:
            lines = path.read_text(encoding="utf-8").splitlines()
        except UnicodeDecodeError:
            continue  # pictures
        read += 1
        for number, line in enumerate(lines, 1):
            for pattern in (PLACES, PUT_OFF):
                if found := pattern.search(line):
                    faults.append(f"{path.relative_to(root)}:{number}: {found[0]}")
    assert read > 100, f"there are hardly any files in {root}"
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
