"""describe --schema: what editors know of a deck. Judged by Debian's python3-jsonschema, on documents that PyYAML reads, both
independent of the program's own reader."""

import json
from pathlib import Path
from unittest import SkipTest

from claims import DECK, changed, claim, main

ROOT = Path(__file__).resolve().parents[2]
COMMITTED = ROOT / "docs/guide/deck.schema.json"
MODELINE = "# yaml-language-server: $schema="


def shipped_decks():
    decks = [path for folder in ("cases", "docs", "validation") for path in sorted((ROOT / folder).rglob("*.yaml"))]
    decks = [path for path in decks if path.read_text().find("\nbodies:") >= 0]
    assert len(decks) > 10, "the decks are elsewhere"
    return decks


def validator():
    """Of the committed schema, which another claim compares with the program's."""
    try:
        import jsonschema
        import yaml
    except ImportError as missing:
        raise SkipTest(f"{missing}; install python3-jsonschema and python3-yaml")
    schema = json.loads(COMMITTED.read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    judge = jsonschema.Draft7Validator(schema)
    return lambda text: [f"{'.'.join(map(str, each.absolute_path))}: {each.message}" for each in judge.iter_errors(yaml.safe_load(text))]


@claim("schema: the one beside the deck reference is up to date (perimpact describe --schema writes it)")
def _(t):
    t.assertTrue(t.expect_success("describe", "--schema").out == COMMITTED.read_text(), "docs/guide/deck.schema.json is of another state of the program")


@claim("schema: every shipped deck is valid, and its first line is a valid path to the schema")
def _(t):
    faults = validator()
    for deck in shipped_decks():
        t.assertEqual(faults(deck.read_text()), [], deck)
        first = deck.read_text().splitlines()[0]
        t.assertTrue(first.startswith(MODELINE), f"{deck} begins with {first}")
        t.assertEqual((deck.parent / first.removeprefix(MODELINE)).resolve(), COMMITTED, deck)


@claim("schema: the deck recorded in run.json is valid too")
def _(t):
    faults = validator()
    t.expect_success("run", t.deck(("end: 20 us", "end: 1 us")), "--out", "r")
    t.assertEqual(faults(json.dumps(t.report("r")["setup"])), [])


@claim("schema: errors in keys, types, words or ranges, and missing keys, are invalid in the schema and refused by the program")
def _(t):
    faults = validator()
    t.assertEqual(faults(DECK), [])
    mistakes = {
        "unknown key": ("spacing: 5 mm", "spacing: 5 mm\n    colour: blue"),
        "misspelt key of a material": ("poissons_ratio", "poisson_ratio"),
        "key of another material": ("poissons_ratio: 0.25", "poissons_ratio: 0.25, influence: constant"),
        "key of another shape": ("{box: {size: [100 mm, 60 mm, 20 mm]}}", "{box: {size: [100 mm, 60 mm, 20 mm]}, scale: 2}"),
        "two shapes": ("{box: {size: [100 mm, 60 mm, 20 mm]}}", "{box: {size: [100 mm, 60 mm, 20 mm]}, sphere: {diameter: 1}}"),
        "no shape": ("{box: {size: [100 mm, 60 mm, 20 mm]}}", "{}"),
        "missing required key": ("time: {end: 20 us}", "time: {}"),
        "missing required map": ("time: {end: 20 us}\n", ""),
        "missing selector": ("model: ordinary-state, ", ""),
        "missing key of a material": (", density: 8000 kg/m3", ""),
        "unknown word": ("detector: swept", "detector: sweep"),
        "unknown material": ("ordinary-state", "ordinary"),
        "text for a number": ("mass: 1 kg", "mass: heavy"),
        "two numbers for one": ("mass: 1 kg", "mass: 1 2"),
        "list for a number": ("mass: 1 kg", "mass: [1]"),
        "number for a list": ("[0, -32 m/s, 0]", "32"),
        "two numbers of three": ("[0, -32 m/s, 0]", "[0, -32]"),
        "word for a map": ("contact:\n  impactors: {detector: swept}", "contact: swept"),
        "half a picture": ("frames: 4", "frames: 4.5"),
        "out of range": ("0.25", "0.6"),
        "at the excluded end of a range": ("mass: 1 kg", "mass: 0"),
        "no degree of freedom": ("free_dofs: [y]", "free_dofs: [Y]"),
        "a degree of freedom twice": ("free_dofs: [y]", "free_dofs: [y, y]"),
        "name that is no name": ("  plate:\n", "  a plate:\n"),
    }
    for name, change in mistakes.items():
        t.assertNotEqual(faults(changed(DECK, change)), [], name)
        t.assertEqual(t.run_program("check", t.deck(change)).code, 2, name)


@claim("schema: numbers may be plain or text with any unit, in each form that the program reads")
def _(t):
    faults = validator()
    for spacing in ("5 mm", "5mm", "0.005", "5e-3", "5.e-3 m", ".5 cm", "'5 mm'", "+5 mm"):
        change = ("spacing: 5 mm", f"spacing: {spacing}")
        t.assertEqual(faults(changed(DECK, change)), [], spacing)
        t.expect_success("check", t.deck(change), "--out", "r")
    for damping in ("0.5 1/s", "0.5 Hz"):
        t.assertEqual(faults(changed(DECK, ("spacing: 5 mm", f"spacing: 5 mm\n    boundary_conditions: {{sea: {{floating: {{damping: {damping}}}}}}}"))), [], damping)


main()
