"""The page that the program embeds, report/dist/template.html, was built from the sources beside it: it tells their fingerprint.

    report_template.py ROOT
"""

import hashlib
import re
import sys
from pathlib import Path

MARK = "<!--data of the run-->"


def fingerprint(report):
    """As report/vite.config.ts makes it."""
    names = ["index.html", "package-lock.json", "package.json", "tsconfig.json", "vite.config.ts", *(f"src/{path.name}" for path in (report / "src").iterdir())]
    digest = hashlib.sha256()
    for name in sorted(names):
        digest.update(f"{name}\n".encode() + (report / name).read_bytes())
    return digest.hexdigest()


def main():
    report = Path(sys.argv[1]) / "report"
    page = (report / "dist/template.html").read_text(encoding="utf-8")
    faults = []
    reported = re.search(r'<meta name="sources" content="(\w+)"', page)
    if not reported or reported[1] != fingerprint(report):
        faults.append("report/dist/template.html was not built from these sources: npm ci && npm run build in report/, and commit it")
    if page.count(MARK) != 1:
        faults.append(f"report/dist/template.html holds {MARK} {page.count(MARK)} times, but needs it once")
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
