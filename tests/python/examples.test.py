"""The examples of the guide run with the results that the guide states; the installed package is complete."""

import ast
import os
import subprocess
import sys

import package
from claims import claim, main
from package import number_before, run_example


@claim("examples: each names the packages that it imports, with those of Debian")
def imports(test):
    scripts = sorted((package.ROOT / "python" / "examples").glob("*.py"))
    test.assertGreater(len(scripts), 2)
    for script in scripts:
        tree = ast.parse(script.read_text())
        nodes = [node for node in ast.walk(tree) if isinstance(node, (ast.Import, ast.ImportFrom))]
        roots = {name.split(".")[0] for node in nodes for name in ([node.module] if isinstance(node, ast.ImportFrom) else [one.name for one in node.names])}
        others = {root for root in roots if root not in sys.stdlib_module_names and root != "perimpact"}
        for root in others:
            test.assertRegex(ast.get_docstring(tree), rf"(?s)Imports .*\b{root}\b.*python3-{root}\b", script.name)


@claim("example impact: the cone made with NumPy breaks the ice")
def impact(test):
    printed = run_example(test, "impact")
    test.assertGreater(number_before(printed, " bonds broke"), 100)
    test.assertGreater(number_before(printed, " mm, and"), 0.5)


@claim("example user_force: the springs return the plate, and the energy balance closes")
def user_force(test):
    printed = run_example(test, "user_force")
    free, on_springs = (float(line.split(" is at ")[1].split(" mm")[0]) for line in printed.splitlines()[:2])
    test.assertLess(free, 2 * on_springs)
    test.assertLess(free, 0)
    closing = number_before(printed, " J of 2.5 J")
    test.assertLess(closing, 1e-3)  # of the 2.5 J: contact has the largest energy balance error (docs/theory/energy.md)


@claim("example grains: the wheel receives the momentum loss of the grains, and no grain penetrates")
def grains(test):
    printed = run_example(test, "grains")
    test.assertGreater(abs(number_before(printed, " rad/s")), 0.5)
    test.assertLess(number_before(printed, " relative error"), 1e-10)
    test.assertEqual(printed.splitlines()[-1], "grains inside a paddle: 0")


@claim("the installed package is complete in the Python package folder of the prefix")
def installed(test):
    build = os.path.dirname(test.program)
    prefix = test.folder / "prefix"
    subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", prefix], check=True, capture_output=True)
    (folder,) = prefix.glob("lib/python3*/*-packages")
    test.assertEqual(sorted(p.name for p in (folder / "perimpact").iterdir() if p.suffix != ".so"), ["__init__.py", "__init__.pyi", "fccda.py", "fccda.pyi", "frd.py", "modes.py", "py.typed", "results.py"])
    code = "import perimpact; print(perimpact.__version__, perimpact.Mesh.box([1, 1, 1], 1), perimpact.__file__)"
    environment = {**test.environment, "PYTHONPATH": str(folder)}
    printed = subprocess.run([sys.executable, "-c", code], env=environment, cwd=test.folder, capture_output=True, text=True, check=True).stdout
    version = test.run_program("version").out.split()[1]
    test.assertEqual(printed.strip(), f"{version} <perimpact.Mesh of 8 vertices and 12 faces> {folder / 'perimpact' / '__init__.py'}")


main()
