"""The page docs/guide/python_reference.md, from the stubs and the docstrings: python3 python/reference.py > docs/guide/python_reference.md

Needs the built package: PYTHONPATH=build/release/python. Each name, its signature as the stubs have it, and its docstring.
"""

import ast
import importlib
import inspect
import re
import sys
from pathlib import Path

STUBS = Path(__file__).parent / "src" / "perimpact"

HEAD = """\
# Reference of the Python package

*This page is written by `python/reference.py` from the docstrings; [python.md](python.md) is the guide.*

Units are SI. Arrays are NumPy's; `ArrayLike` is anything that NumPy makes an array of, a vector being three numbers.
"""


def text_of(thing):
    """The docstring, without the lines that pybind11 puts before it; lines that explain an argument as a list."""
    lines = inspect.getdoc(thing).splitlines()
    if lines and "->" in lines[0] and "(" in lines[0]:
        lines = lines[2:]
    text, is_list = [], False
    for line in lines:
        explains = re.match(r"([a-z]\w*(?:, [a-z]\w*)*): (.*)", line)
        if explains and len(lines) > 1:
            text += [] if is_list or not text or not text[-1] else [""]
            line = f"- `{explains[1]}`: {explains[2]}"
        is_list = (is_list or bool(explains)) and bool(line)
        text.append(line.replace("``", "`"))
    return "\n".join(text).strip()


def signature(name, function):
    """As the stub has it, without self, on one line."""
    arguments = ast.unparse(function.args).removeprefix("self, ").removeprefix("self")
    returns = ast.unparse(function.returns)
    return f"{name}({arguments})" + ("" if returns == "None" else f" → {returns}")


def is_property(node):
    return any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list)


def of_class(module, node):
    yield f"### {module.__name__}.{node.name}\n"
    actual = getattr(module, node.name)
    yield text_of(actual) + "\n"
    for item in node.body:
        if not isinstance(item, ast.FunctionDef):
            continue
        member = getattr(actual, item.name)
        if is_property(item):
            yield f"- **{item.name}** `{ast.unparse(item.returns)}`: {text_of(member)}"
        elif item.name == "__init__":
            yield f"**`{signature(node.name, item)}`**\n\n{text_of(member)}\n"
        elif item.name == "__len__":
            yield "- **len()** `int`: " + {"Mesh": "how many faces there are.", "Body": "how many particles there are."}[node.name]
        else:
            yield f"\n**`{signature(item.name, item)}`**\n\n{text_of(member)}\n"


def page():
    yield HEAD
    for name in ("perimpact", "perimpact.fccda"):
        module = importlib.import_module(name)
        stub = STUBS / ("fccda.pyi" if name.endswith("fccda") else "__init__.pyi")
        yield f"## {name}\n"
        for node in ast.parse(stub.read_text()).body:
            if isinstance(node, ast.ClassDef):
                yield from of_class(module, node)
                yield ""
            elif isinstance(node, ast.FunctionDef):
                yield f"### {name}.{node.name}\n\n**`{signature(node.name, node)}`**\n\n{text_of(getattr(module, node.name))}\n"


if __name__ == "__main__":
    sys.stdout.write(re.sub(r"\n{3,}", "\n\n", "\n".join(page())).rstrip() + "\n")
