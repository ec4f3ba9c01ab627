"""The numbers of `Thresholds` in core/tracking/event_options.h, in order: as rows of a C++ table, or as names with their
comments. Usage: threshold_table.py EVENT_OPTIONS.H > threshold_table.inc"""
import re
import sys

NUMBER = re.compile(r"^\s+(double|int) (\w+) = ([^;]*);\s*///< (.*)$")


def numbers(header):
    """Yields (name, type, comment) of each number."""
    text = open(header).read()
    text = text[text.index("struct Thresholds {"):text.index("#ifdef VVR_THRESHOLDS_VARY")]
    members = []
    for line in text.splitlines()[1:]:
        if re.match(r"^    struct \{", line):
            members = []
        elif closing := re.match(r"^    \} (\w+);", line):
            for name, kind, comment in members:
                yield f"{closing[1]}.{name}", kind, comment
            members = []
        elif found := NUMBER.match(line):
            kind, name, _, comment = found.groups()
            if line.startswith("        "):
                members.append((name, kind, comment))
            else:
                yield name, kind, comment


if __name__ == "__main__":
    for name, _, _ in numbers(sys.argv[1]):
        print(f'        Threshold{{"{name}", &thresholds.{name}}},')
