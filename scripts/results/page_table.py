"""Tables of pages, each between its two marks: <!-- table.py: NAME --> and <!-- end -->."""

import re


def write_table(text, name, lines):
    """The text of a page with these lines in place of those of the table `name`."""
    begin, end = f"<!-- table.py: {name} -->", "<!-- end -->"
    pattern = re.compile(re.escape(begin) + ".*?" + re.escape(end), re.DOTALL)
    assert pattern.search(text), f"the page has no table {name}"
    return pattern.sub(lambda _: "\n".join([begin, *lines, end]), text)
