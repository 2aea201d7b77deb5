"""What Doxygen reads instead of a header (INPUT_FILTER): the same, except that

  - the comment at its begin describes the file;
  - indented lines of comments, which are formulas and examples, keep their layout;
  - variables declared together are declared one by one, each with the comment of the line.
"""

import re
import sys

# `  Vec3d start, end;  ///< [m]`, with initialisers without commas or braces in them
TOGETHER = re.compile(r"^(\s*)((?:const )?[\w:]+(?:<[\w:, ]+>)?) (\w+(?: = [^,;{}()]+)?(?:, \w+(?: = [^,;{}()]+)?)+);\s*(///<.*)$")
BRACED = re.compile(r"^(\s*)(T) (\w+\{\}(?:, \w+\{\})+);\s*(///<.*)$")
INDENTED = re.compile(r"^\s*///   +\S")
EMPTY = re.compile(r"^\s*///$")
ITEM = re.compile(r"^\s*///\s+(-|\d+\.) ")


def lines_of(text):
    lines = text.splitlines()
    is_laid_out = is_in_list = False
    for number, line in enumerate(lines):
        if number == 0 and line.startswith("///"):
            yield "/// @file"
        is_in_list = bool(ITEM.match(line)) or (is_in_list and bool(INDENTED.match(line)))
        begins = bool(INDENTED.match(line)) and not is_in_list
        # an empty line in between belongs to the layout
        goes_on = is_laid_out and bool(EMPTY.match(line)) and number + 1 < len(lines) and bool(INDENTED.match(lines[number + 1]))
        if begins and not is_laid_out:
            yield "/// @code{.unparsed}"
        if is_laid_out and not begins and not goes_on:
            yield "/// @endcode"
        is_laid_out = begins or (is_laid_out and goes_on)
        if found := TOGETHER.match(line) or BRACED.match(line):
            indent, kind, names, comment = found.groups()
            yield from (f"{indent}{kind} {name};  {comment}" for name in names.split(", "))
        else:
            yield line


with open(sys.argv[1], encoding="utf-8") as file:
    print("\n".join(lines_of(file.read())))
