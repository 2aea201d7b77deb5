"""new: starter decks."""

from claims import claim, main

STARTERS = ("plate", "ship", "propeller")


@claim("new: each starter deck passes check without a warning, and runs its first steps")
def _(t):
    for name in STARTERS:
        t.assertIn(f"perimpact run {name}.yaml", t.expect_success("new", name).out)
        t.expect_no_warning("check", f"{name}.yaml")
        end = {"plate": "4 us", "ship": "20 ms", "propeller": "40 us"}[name]
        t.expect_success("run", f"{name}.yaml", "--threads", "1", "--set", f"time.end={end}", "--set", "output.frames=1", "--set", f"output.history_interval={end}")
        t.assertEqual(t.report(f"results/{name}")["outcome"], "finished", name)


@claim("new: the first line names the schema, which is next to the deck and equals that of the program")
def _(t):
    (t.folder / "mine").mkdir()
    t.expect_success("new", "plate", "mine/first.yaml")
    first = (t.folder / "mine/first.yaml").read_text().splitlines()[0]
    t.assertEqual(first, "# yaml-language-server: $schema=perimpact.schema.json")
    t.assertEqual((t.folder / "mine/perimpact.schema.json").read_text(), t.expect_success("describe", "--schema").out)


@claim("new: existing deck and schema are kept without --force")
def _(t):
    deck, schema = t.folder / "plate.yaml", t.folder / "perimpact.schema.json"
    deck.write_text("mine")
    t.expect_complaint(t.run_program("new", "plate"), 2, "plate.yaml already exists; ", "--force")
    t.assertEqual((deck.read_text(), schema.exists()), ("mine", False))
    schema.write_text("mine too")
    t.assertIn("perimpact.schema.json is kept", t.expect_success("new", "ship").out)
    t.assertEqual(schema.read_text(), "mine too")
    t.expect_success("new", "plate", "--force")
    t.assertNotEqual((deck.read_text(), schema.read_text()), ("mine", "mine too"))


@claim("new: an unknown starter deck and an unwritable path are one sentence each")
def _(t):
    t.expect_complaint(t.run_program("new", "plat"), 2, "there is no starter deck plat; did you mean plate?")
    t.expect_complaint(t.run_program("new", "tank"), 2, "there is no starter deck tank; known here: plate, propeller, ship.")
    t.expect_complaint(t.run_program("new", "ship", "far/away.yaml"), 2, "far/away.yaml cannot be written: there is no folder far. Create it first")
    t.expect_complaint(t.run_program("new", "ship", "."), 2, ". already exists")
    t.assertEqual(t.files("."), [])


main()
