"""Runs decks for the topics: one folder per result, none run twice."""

import importlib.util
import json
import os
import resource
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


class Runner:
    def __init__(self, program, results):
        self.program, self.results = Path(program).resolve(), Path(results).resolve()

    def folder(self, topic, name):
        return self.results / topic / name

    def run(self, topic, name, deck, *settings):
        """Folder of the results of the deck with these settings ("time.end=1 s"); a finished run is reused."""
        folder, wanted = self.folder(topic, name), json.dumps([str(deck), *settings])
        noted = folder / "settings.json"
        if noted.exists() and noted.read_text() == wanted and '"outcome": "finished"' in (folder / "run.json").read_text():
            return folder
        print(f"  {topic}/{name}", flush=True)
        folder.mkdir(parents=True, exist_ok=True)
        noted.unlink(missing_ok=True)
        words = [word for setting in settings for word in ("--set", setting)]
        done = self.call("run", ROOT / deck, "--out", folder, "--force", *words)
        if done.returncode:
            sys.exit(f"error: {topic}/{name} ended with {done.returncode}: {done.stderr.strip()}")
        noted.write_text(wanted)
        return folder

    def call(self, *arguments):
        """Calls the program; returns its exit code and output."""
        environment = {**os.environ, "OMP_WAIT_POLICY": "passive"}
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, env=environment)


def report(folder):
    """run.json"""
    return json.loads((Path(folder) / "run.json").read_text())


def processor_seconds():
    """Of everything run so far."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)


def script_of(path):
    """A script of a case as a module: scripts of different cases have the same name."""
    path = ROOT / path
    sys.path.insert(0, str(path.parent))
    try:
        spec = importlib.util.spec_from_file_location("_".join(path.with_suffix("").parts[-2:]), path)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    finally:
        sys.path.remove(str(path.parent))
    return module
