"""The numbers of `Thresholds` in core/tracking/event_options.h, in order: as rows of a C++ table, or as names with their
comments. Usage: threshold_table.py EVENT_OPTIONS.H > threshold_table.inc"""
import re
import sys

NUMBER = re.compile(r"^(    |        )(?:double|int) (\w+) = [^;]*;\s*///< (.*)$", re.MULTILINE)
END_OF_GROUP = re.compile(r"^    \} (\w+);", re.MULTILINE)


def numbers(header):
    """Yields (name, comment) of each number."""
    text = open(header).read()
    for found in NUMBER.finditer(text):
        indent, name, comment = found.groups()
        group = END_OF_GROUP.search(text, found.end())[1] + "." if len(indent) == 8 else ""
        yield group + name, comment


if __name__ == "__main__":
    for each, _ in numbers(sys.argv[1]):
        print(f'        {{"{each}", &thresholds.{each}}},')
