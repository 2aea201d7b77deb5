"""Help, completion and manual pages, all written from the table that parses the command line."""

import re
import shutil
import subprocess
import unittest
from pathlib import Path

from claims import claim, main

ROOT = Path(__file__).resolve().parents[2]


def commands_of(t):
    """name → long options, from --help; shapes as "shape hull"."""

    def subcommands(text):
        return re.findall(r"^  (\w+) {2,}", text.partition("Subcommands:")[2], re.MULTILINE)

    def options(text):
        return set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", text, re.MULTILINE)) - {"--help"}

    found = {}
    for name in subcommands(t.expect_success("--help").out):
        text = t.expect_success(name, "--help").out
        found[name] = options(text)
        for below in subcommands(text):
            found[f"{name} {below}"] = options(t.expect_success(name, below, "--help").out)
    t.assertGreater(len(found), 14)
    t.assertIn("--set", found["run"])
    return found


def with_program(name):
    path = shutil.which(name)
    if not path:
        raise unittest.SkipTest(f"{name} is not installed")
    return path


def completed_by_bash(t, *words):
    """What bash offers for the last of the words."""
    script = t.folder / "completion.bash"
    script.write_text(t.expect_success("completion", "bash").out)
    shown = subprocess.run(["bash", "-c", 'source "$0"; COMP_WORDS=(perimpact "$@"); COMP_CWORD=$#; _perimpact; printf "%s\\n" "${COMPREPLY[@]}"', script, *words],
                           cwd=t.folder, capture_output=True, text=True, check=True)
    t.assertEqual(shown.stderr, "")
    return set(shown.stdout.split("\n")) - {""}


@claim("command line: bash completes all commands and all options of each, files and folders where they are meant, and words of a choice")
def _(t):
    commands = commands_of(t)
    t.assertEqual(completed_by_bash(t, ""), {name for name in commands if " " not in name})
    for name, options in commands.items():
        t.assertEqual({each for each in completed_by_bash(t, *name.split(), "--") if each.startswith("--")} - {"--help"}, options, name)
    (t.folder / "my deck.yaml").write_text("")
    (t.folder / "my results").mkdir()
    t.assertEqual(completed_by_bash(t, "run", "my"), {"my deck.yaml", "my results"})
    t.assertEqual(completed_by_bash(t, "run", "--threads", "4", "--resume", "my"), {"my deck.yaml", "my results"})
    t.assertEqual(completed_by_bash(t, "run", "deck.yaml", "--out", "my"), {"my results"})
    t.assertEqual(completed_by_bash(t, "run", "deck.yaml", "--progress", ""), {"line", "json"})
    t.assertEqual(completed_by_bash(t, "new", "p"), {"plate", "propeller"})
    t.assertEqual(completed_by_bash(t, "completion", ""), {"bash", "zsh", "fish"})
    t.assertEqual(completed_by_bash(t, "shape", ""), {name.removeprefix("shape ") for name in commands if name.startswith("shape ")})
    t.assertEqual(completed_by_bash(t, "run", "deck.yaml", "--set", ""), set())
    t.assertEqual(completed_by_bash(t, "ru"), {"run"})


@claim("command line: fish completes all commands and all options of each, and words of a choice")
def _(t):
    fish = with_program("fish")
    script = t.folder / "completion.fish"
    script.write_text(t.expect_success("completion", "fish").out)

    def completed(line):
        environment = {**t.environment, "HOME": str(t.folder), "XDG_CONFIG_HOME": str(t.folder), "XDG_DATA_HOME": str(t.folder)}
        shown = subprocess.run([fish, "--no-config", "-c", f"source {script}; complete --do-complete '{line}'"], cwd=t.folder, env=environment, capture_output=True,
                               text=True, check=True)
        t.assertEqual(shown.stderr, "")
        return {each.split("\t")[0] for each in shown.stdout.splitlines()}

    commands = commands_of(t)
    t.assertEqual({each for each in completed("perimpact ") if not each.startswith("-")}, {name for name in commands if " " not in name})
    for name, options in commands.items():
        t.assertEqual({each for each in completed(f"perimpact {name} --") if each.startswith("--")} - {"--help"}, options, name)
    t.assertEqual(completed("perimpact run deck.yaml --progress "), {"line", "json"})
    t.assertEqual(completed("perimpact new p"), {"plate", "propeller"})


@claim("command line: zsh loads its completion, which has all commands and all options of each")
def _(t):
    zsh = with_program("zsh")
    text = t.expect_success("completion", "zsh").out
    (t.folder / "_perimpact").write_text(text)
    subprocess.run([zsh, "-n", t.folder / "_perimpact"], check=True)
    # the words that _arguments and _describe get, as the shell itself passes them
    probe = 'function _arguments { print -l -- "$@"; state=$STATE }; function _describe { print -l -- "${(P@)2}" }; words=("${(@s: :)WORDS}"); CURRENT=2; . ./_perimpact'

    def passed(state, words):
        environment = {**t.environment, "STATE": state, "WORDS": words}
        done = subprocess.run([zsh, "-f", "-c", probe], cwd=t.folder, env=environment, capture_output=True, text=True, check=True)
        t.assertEqual(done.stderr, "")
        return done.stdout

    commands = commands_of(t)
    t.assertEqual(set(re.findall(r"^([a-z]+):", passed("command", ""), re.MULTILINE)), {name for name in commands if " " not in name})
    for name, options in commands.items():
        if " " in name or any(other.startswith(name + " ") for other in commands):
            continue
        specifications = passed("rest", name).partition(":->rest")[2]
        t.assertEqual(set(re.findall(r"^\*?(--[\w-]+)\[", specifications, re.MULTILINE)) - {"--help"}, options, name)
    for name, options in commands.items():  # of the shapes, whose function is called by that of `shape`
        if name.startswith("shape "):
            function = text.partition(f"_perimpact_{name.replace(' ', '_')}() {{")[2].partition("\n}\n")[0]
            t.assertEqual(set(re.findall(r"'\*?(--[\w-]+)\[", function)) - {"--help"}, options, name)


@claim("command line: the manual page names all commands and options, and man and mandoc find nothing wrong in it")
def _(t):
    page = t.folder / "perimpact.1"
    page.write_text(t.expect_success("manual").out)
    environment = {**t.environment, "MANWIDTH": "200", "MAN_KEEP_FORMATTING": "", "LC_ALL": "C.UTF-8"}
    checked = 0
    if shutil.which("mandoc"):
        found = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", page], capture_output=True, text=True)
        t.assertEqual([line for line in found.stdout.splitlines() if "STYLE" not in line], [])
        shown = subprocess.run(["mandoc", "-T", "ascii", "-O", "width=200", page], capture_output=True, text=True, check=True).stdout
        plain = re.sub(r".\x08", "", shown)
        for name, options in commands_of(t).items():
            part = re.split(r"\n   (?=perimpact )", plain.partition(f"\n   perimpact {name}")[2])[0]
            for option in options:
                t.assertRegex(part, rf"(?m)^ +(-\w, )?{option}\b", f"{name} {option}")
        checked += 1
    if shutil.which("man"):
        shown = subprocess.run(["man", "--warnings", "-l", page], capture_output=True, text=True, env=environment)
        t.assertEqual((shown.returncode, shown.stderr), (0, ""))
        checked += 1
    if checked == 0:
        raise unittest.SkipTest("neither man nor mandoc is installed")


@claim("command line: no sentence of the manual ends in two full stops")
def _(t):
    for words in (["manual"], ["manual", "--markdown"]):
        t.assertNotRegex(t.expect_success(*words).out, r"[^.]\.\.(\s|\||$)")


@claim("command line: the page of the guide is that of the program")
def _(t):
    t.assertTrue(t.expect_success("manual", "--markdown").out == (ROOT / "docs/guide/command_line.md").read_text(),
                 "docs/guide/command_line.md is of another state of the program; write it with perimpact manual --markdown")


@claim("command line: unknown words of a choice are refused with the nearest one, or with all")
def _(t):
    t.expect_complaint(t.run_program("completion", "zhs"), 2, "there is no completion for the shell zhs; did you mean zsh?")
    t.expect_complaint(t.run_program("run", t.deck(), "--progress", "jsn"), 2, "--progress: jsn is unknown, known are line, json; perimpact run --help")


main()
