"""What `cmake --install` leaves: the program, cases that run from there, and the schema where their first line says."""

import os
import subprocess
from pathlib import Path

from claims import claim, main


@claim("install: the program runs from a relocated folder, and an installed case passes check and finds its schema")
def _(t):
    build = Path(t.program).parent
    first = t.folder / "first"
    subprocess.run(["cmake", "--install", build, "--component", "perimpact", "--prefix", first], check=True, stdout=subprocess.DEVNULL)
    prefix = first.rename(t.folder / "moved")
    t.program = str(prefix / "bin/perimpact")
    t.assertRegex(t.expect_success("version").out, r"^perimpact \d")
    deck = prefix / "share/perimpact/cases/kalthoff_winkler/deck.yaml"
    t.expect_success("check", deck, "--out", "r")
    schema = deck.read_text().splitlines()[0].removeprefix("# yaml-language-server: $schema=")
    t.assertEqual((deck.parent / schema).read_text(), t.expect_success("describe", "--schema").out)
    for path in ("share/man/man1/perimpact.1.gz", "share/doc/perimpact/copyright", "share/doc/perimpact/changelog.gz"):
        t.assertTrue((prefix / path).is_file(), path)
    scripts = [path for path in (prefix / "share/perimpact/cases").rglob("*") if path.suffix in (".py", ".sh")]
    t.assertTrue(all(os.access(path, os.X_OK) == os.access(source_of(path, prefix), os.X_OK) for path in scripts))


def source_of(path, prefix):
    return Path(__file__).resolve().parents[2] / path.relative_to(prefix / "share/perimpact")


main()
