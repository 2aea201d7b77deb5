"""What `cmake --install` leaves: the program, cases that run from there, and the schema where their first line says."""

import io
import os
import shutil
import subprocess
import sys
import tarfile
import unittest
from pathlib import Path

from claims import MPIRUN_AS_ROOT, claim, main


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
    tutorial = prefix / "share/perimpact/docs/guide/tutorials/1_plate.yaml"
    t.expect_success("check", tutorial, "--out", "r")
    t.assertTrue((tutorial.parent / tutorial.read_text().splitlines()[0].removeprefix("# yaml-language-server: $schema=")).is_file())
    for path in ("share/bash-completion/completions/perimpact", "share/zsh/vendor-completions/_perimpact", "share/fish/vendor_completions.d/perimpact.fish",
                 "share/man/man1/perimpact.1.gz", "share/doc/perimpact/copyright", "share/doc/perimpact/changelog.gz"):
        t.assertTrue((prefix / path).is_file(), path)
    scripts = [path for path in (prefix / "share/perimpact/cases").rglob("*") if path.suffix in (".py", ".sh")]
    t.assertGreater(len(scripts), 20)
    t.assertTrue(all(os.access(path, os.X_OK) == os.access(source_of(path, prefix), os.X_OK) for path in scripts))


@claim("install: of the Debian packages the program and the Python package run where they are unpacked, and two processes once perimpact-mpi is beside them")
def _(t):
    build = Path(t.program).parent
    for tool in "cpack", "dpkg-deb", "dpkg-shlibdeps", "file":
        if not shutil.which(tool):
            raise unittest.SkipTest(f"{tool} is not installed")
    if not (build / "python/perimpact").is_dir():
        raise unittest.SkipTest("the Python package is not built (PERIMPACT_PYTHON)")
    if not (build / "libperimpact_ranks.so").exists():
        raise unittest.SkipTest("the program was built without MPI")
    subprocess.run(["cpack", "--config", build / "CPackConfig.cmake", "-G", "DEB", "-B", t.folder / "made", "-D", "CPACK_COMPONENTS_ALL=perimpact;python;mpi",
                    "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip"], check=True, stdout=subprocess.DEVNULL, cwd=t.folder)
    root = t.folder / "root"
    packages = {path.name.partition("_")[0]: path for path in (t.folder / "made").glob("*.deb")}
    t.assertEqual(set(packages), {"perimpact", "python3-perimpact", "perimpact-mpi"})
    for package in "perimpact", "python3-perimpact":
        subprocess.run(["dpkg-deb", "-x", packages[package], root], check=True)

    def field(package, name):
        return subprocess.run(["dpkg-deb", "-f", packages[package], name], capture_output=True, text=True, check=True).stdout.strip()

    minor = sys.version_info.minor
    depends = field("python3-perimpact", "Depends").split(", ")
    for each in f"python3 (>= 3.{minor}~)", f"python3 (<< 3.{minor + 1}~)", "python3-numpy":
        t.assertIn(each, depends)
    t.assertTrue(any(each.startswith("libhdf5") for each in depends), depends)
    t.assertFalse([each for each in field("perimpact", "Depends").split(", ") if each.startswith("python3")])
    t.assertEqual(field("python3-perimpact", "Section"), "python")
    scripts = subprocess.run(["dpkg-deb", "--ctrl-tarfile", packages["python3-perimpact"]], capture_output=True, check=True).stdout
    with tarfile.open(fileobj=io.BytesIO(scripts)) as control:
        t.assertLessEqual({"./postinst", "./prerm"}, set(control.getnames()))

    modules = [path.parent for path in root.rglob("perimpact/__init__.py")]
    t.assertEqual(len(modules), 1)
    t.assertEqual(len(list(modules[0].glob("_core.*.so"))), 1)
    t.assertTrue((modules[0] / "py.typed").is_file())
    setup = {"time": {"end": 1e-6}, "bodies": {"b": {"shape": {"box": {"size": [0.04, 0.04, 0.04]}}, "spacing": 0.01,
             "material": {"model": "bond-based", "youngs_modulus": 1e9, "density": 1000}}}}
    code = f"import perimpact; s = perimpact.Simulation({setup!r}); s.run(); print(perimpact.__file__, s.time >= 1e-6)"
    alone = {"PATH": "/usr/bin:/bin", "PYTHONPATH": str(modules[0].parent), "HOME": str(t.folder)}
    done = subprocess.run(["/usr/bin/python3", "-c", code], cwd=t.folder, env=alone, capture_output=True, text=True)
    t.assertEqual((done.stdout, done.stderr), (f"{modules[0] / '__init__.py'} True\n", ""))
    examples = next(root.rglob("doc/python3-perimpact/examples"))
    t.assertEqual({path.name for path in examples.iterdir()}, {"dolfinx_modes.py", "grains.py", "impact.py", "lammps_grains.py", "lammps_net.py", "pysph_boat.py", "user_force.py"})

    depends = [each.split()[0] for each in field("perimpact-mpi", "Depends").split(", ")]
    t.assertLessEqual({"perimpact", "openmpi-bin"}, set(depends))
    t.assertTrue(any(each.startswith("libopenmpi") for each in depends), depends)
    t.assertFalse([each for each in field("perimpact", "Depends").split(", ") if "mpi" in each.replace("perimpact", "")])
    deck = t.deck(("time: {end: 20 us}", "time: {end: 3 us}"))
    two = ["mpirun", "--oversubscribe", "-n", "2", root / "usr/bin/perimpact", "run", deck, "--out", "two", "--threads", "1", "--no-report"]
    done = subprocess.run(two, cwd=t.folder, env=os.environ | MPIRUN_AS_ROOT, capture_output=True, text=True)
    t.assertEqual(done.returncode, 2, done)
    t.assertIn("error: a run of 2 processes needs libperimpact_ranks.so, which is not installed; install the package perimpact-mpi", done.stderr)
    subprocess.run(["dpkg-deb", "-x", packages["perimpact-mpi"], root], check=True)
    done = subprocess.run(two, cwd=t.folder, env=os.environ | MPIRUN_AS_ROOT, capture_output=True, text=True)
    t.assertEqual(done.returncode, 0, done)
    t.assertEqual(t.report("two")["ranks"], 2)


def source_of(path, prefix):
    return Path(__file__).resolve().parents[2] / path.relative_to(prefix / "share/perimpact")


main()
