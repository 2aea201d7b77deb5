"""The stubs match the module, and the reference page matches both."""

import ast
import importlib
import inspect
import re
import subprocess
import sys

import package
from claims import claim, main

import perimpact

STUBS = package.ROOT / "python" / "src" / "perimpact"


def modules():
    return (perimpact, STUBS / "__init__.pyi"), (perimpact.fccda, STUBS / "fccda.pyi")


def stubbed(stub):
    return {node.name: node for node in ast.parse(stub.read_text()).body if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and not node.name.startswith("_")}


def imported(stub):
    """What the stub takes from other modules of the package."""
    return {alias.asname for node in ast.parse(stub.read_text()).body if isinstance(node, ast.ImportFrom) and node.level == 1 for alias in node.names}


def public(names):
    return {name for name in names if not name.startswith("_")}


def is_property(node):
    return any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list)


def stub_parameters(node):
    """name, kind and default of each parameter: ("axis", "positional", "z")"""
    arguments = node.args
    positional = [a.arg for a in arguments.args]
    defaults = [None] * (len(positional) - len(arguments.defaults)) + [ast.unparse(d) for d in arguments.defaults]
    rows = [(name, "positional", default) for name, default in zip(positional, defaults) if name != "self"]
    for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults):
        rows.append((argument.arg, "keyword", None if default is None else ast.unparse(default)))
    return rows


def split_arguments(text):
    """Splits at the commas outside brackets."""
    depth, parts = 0, [""]
    for letter in text:
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


def actual_parameters(function):
    """The same from the signature line that pybind11 adds to the docstring."""
    line = function.__doc__.splitlines()[0]
    inside = line[line.index("(") + 1 : line.rindex(") ->")]
    rows, kind = [], "positional"
    for argument in split_arguments(inside):
        if argument == "*":
            kind = "keyword"
            continue
        name = re.match(r"\w+", argument).group()
        default = argument.split(" = ", 1)[1] if " = " in argument else None
        if name != "self":
            rows.append((name, kind, default))
    return rows


def plain(default):
    """Defaults in a common form: arrays as tuples of numbers, ./folder as text."""
    if default is None:
        return None
    default = re.sub(r"array\((.*)\)", r"\1", default)
    default = re.sub(r"PosixPath\((.*)\)", r"\1", default)
    value = ast.literal_eval(default)
    return tuple(value) if isinstance(value, list) else value


@claim("every public name of the module is in the stubs, and vice versa")
def names(test):
    for module, stub in modules():
        nodes = stubbed(stub)
        test.assertEqual(set(module.__all__), public(nodes) | imported(stub))
        test.assertEqual({name for name in module.__all__ if not hasattr(module, name)}, set())
        for name, node in nodes.items():
            if not isinstance(node, ast.ClassDef):
                continue
            in_stub = public(item.name for item in node.body if isinstance(item, ast.FunctionDef))
            in_class = public(vars(getattr(module, name)))
            test.assertEqual(in_class, in_stub, name)


@claim("parameters of the stubs have the names, kinds and defaults of the module's, and properties are properties")
def signatures(test):
    compared = 0
    for module, stub in modules():
        for name, node in stubbed(stub).items():
            members = [(None, node)] if isinstance(node, ast.FunctionDef) else [(name, item) for item in node.body if isinstance(item, ast.FunctionDef)]
            for owner, item in members:
                where = f"{module.__name__}.{owner or ''}.{item.name}"
                actual = inspect.getattr_static(getattr(module, owner), item.name) if owner else getattr(module, item.name)
                if is_property(item):
                    test.assertIsInstance(actual, property, where)
                    continue
                test.assertNotIsInstance(actual, property, where)
                is_static = any(isinstance(d, ast.Name) and d.id == "staticmethod" for d in item.decorator_list)
                test.assertEqual(isinstance(actual, staticmethod), is_static, where)
                wanted = [(n, k, plain(d)) for n, k, d in stub_parameters(item)]
                found = [(n, k, plain(d)) for n, k, d in actual_parameters(getattr(module, owner).__dict__[item.name] if owner and not is_static else getattr(getattr(module, owner) if owner else module, item.name))]
                test.assertEqual(found, wanted, where)
                compared += 1
    test.assertGreater(compared, 25)


@claim("everything public has a docstring, with the unit of vectors and numbers")
def docstrings(test):
    for module, stub in modules():
        for name, node in stubbed(stub).items():
            thing = getattr(module, name)
            test.assertTrue(thing.__doc__ and thing.__doc__.strip(), name)
            if isinstance(node, ast.FunctionDef):
                continue
            for item in node.body:
                if not isinstance(item, ast.FunctionDef) or item.name.startswith("__"):
                    continue
                text = getattr(thing, item.name).__doc__
                test.assertTrue(text and text.strip(), f"{name}.{item.name}")
                if is_property(item) and "float64" in ast.unparse(item.returns) and item.name not in ("rotation", "history"):
                    test.assertRegex(text, r"\[[^\]]+\]", f"{name}.{item.name} lacks its unit")


@claim("perimpact.modes is there without an import of its own, and also runs as a program")
def modes(test):
    program = "import perimpact; print(perimpact.modes.normalised.__name__)"
    environment = {**test.environment, "PYTHONPATH": sys.path[0]}
    for arguments, words in (["-c", program], "normalised"), (["-W", "error", "-m", "perimpact.modes", "--help"], "usage: python3 -m perimpact.modes"):
        done = subprocess.run([sys.executable, *arguments], env=environment, capture_output=True, text=True)
        test.assertEqual((done.returncode, done.stderr), (0, ""))
        test.assertIn(words, done.stdout)
    with test.assertRaisesRegex(AttributeError, "module 'perimpact' has no attribute 'mode'"):
        perimpact.mode


@claim("the reference page has every public name of perimpact, perimpact.fccda, perimpact.results and perimpact.modes")
def reference_names(test):
    page = (package.ROOT / "docs" / "guide" / "python_reference.md").read_text()
    for module in perimpact, perimpact.fccda, importlib.import_module("perimpact.results"), perimpact.modes:
        own = {name for name, thing in vars(module).items() if not name.startswith("_") and getattr(thing, "__module__", "") == module.__name__ and callable(thing)}
        test.assertGreater(len(own), 2)
        absent = {name for name in own - {"main"} if f"\n### {module.__name__}.{name}\n" not in page}
        test.assertEqual(absent, set(), module.__name__)


@claim("the reference page matches the output of python/reference.py")
def reference(test):
    script = package.ROOT / "python" / "reference.py"
    environment = {**test.environment, "PYTHONPATH": sys.path[0]}
    made = subprocess.run([sys.executable, script], env=environment, capture_output=True, text=True, check=True).stdout
    page = package.ROOT / "docs" / "guide" / "python_reference.md"
    test.assertEqual(made, page.read_text(), "regenerate it: PYTHONPATH=build/release/python /usr/bin/python3 python/reference.py > docs/guide/python_reference.md")


main()
