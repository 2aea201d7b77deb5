"""Pages, comments and messages use the terms of the glossary: none of the expressions in terms.csv stands in them.

    terms.py ROOT

Each line of terms.csv is a regular expression and the terms to use instead. Deprecated names live in one place, deprecated_keys.cpp, and in the
changelog, which lists what was renamed.
"""

import csv
import re
import subprocess
import sys
from pathlib import Path

EXCEPT = ("CHANGELOG.md", "report/licences.txt", "src/io/deck/deprecated_keys.cpp", "tests/", "validation/results/", "docs/guide/deck.schema.json")
READ = (".md", ".hpp", ".h", ".cpp", ".c", ".f90", ".py", ".yaml", ".sh", ".ts", ".in", ".pyi", ".1", ".cmake", ".txt")


def main():
    root = Path(sys.argv[1])
    with open(Path(__file__).with_name("terms.csv"), newline="", encoding="utf-8") as file:
        terms = [(re.compile(row["not used"], re.IGNORECASE), row["instead"]) for row in csv.DictReader(file, delimiter=";")]
    assert len(terms) > 20, "terms.csv holds hardly any terms"
    files = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True, check=True).stdout.splitlines()
    faults, read = [], 0
    for name in files:
        if name.startswith(EXCEPT) or not name.endswith(READ) or not (root / name).is_file():
            continue
        read += 1
        for number, line in enumerate((root / name).read_text(encoding="utf-8").splitlines(), 1):
            for pattern, instead in terms:
                if found := pattern.search(line):
                    faults.append(f'{name}:{number}: "{found[0]}"; use: {instead}')
    assert read > 300, f"only {read} files were read"
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
