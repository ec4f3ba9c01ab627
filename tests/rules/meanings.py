"""Checks that a name has one meaning.

A module's files open only the namespace of that module: core/media is vvr::media, cli is vvr::cli. The rooms of the application
share vvr::app. core/base and cli/library are vvr itself; rows of settings are in vvr::setting wherever they are.

No two types have one qualified name. Two such types make two programs of one: the linker keeps the inline functions of one
of them and drops the other's, and nobody is told. What is in an unnamed namespace belongs to its file alone.
"""

import collections
import re

from includes import APPLICATION, sources

NAMESPACE = re.compile(r"^(?:inline )?namespace ([\w:]+) \{")
TYPE = re.compile(r"^(?:struct|class|enum class|union) (\w+)(?: final)?(?: ?:(?!:)[^;{]*)?(?: \{|$)")


def types_in(text):
    """The qualified names of the types that a file declares at its first column, each with its line."""
    spaces = []  # None = unnamed
    for number, line in enumerate(text.splitlines(), 1):
        if found := NAMESPACE.match(line):
            spaces.append(found[1])
        elif line.startswith("namespace {"):
            spaces.append(None)
        elif line.startswith("}  // namespace") and spaces:
            spaces.pop()
        elif spaces and None not in spaces and (found := TYPE.match(line)):
            yield f"{'::'.join(spaces)}::{found[1]}", number


def namespace_of(file):
    """The namespace of the module that a file is in."""
    module = file.parts[1] if len(file.parts) > 2 else file.parts[0]
    if str(file.parent) in APPLICATION:
        module = "app"
    return "vvr" if module in ("base", "library") else f"vvr::{module}"


def strays(file, text):
    """The namespaces that a file opens and that are not of its module."""
    module = namespace_of(file)
    for number, line in enumerate(text.splitlines(), 1):
        if found := NAMESPACE.match(line):
            ours = found[1] in ("vvr::setting", module) or found[1].startswith(f"{module}::")
            if found[1].split("::")[0] == "vvr" and not ours:
                yield f"{file}:{number}: {found[1]} is not the namespace of this module, {module}"


def complaints(root):
    said = []
    places = collections.defaultdict(list)
    for file, text in sources(root):
        said += strays(file, text)
        for name, line in types_in(text):
            places[name].append(f"{file}:{line}")
    return said + [f"{name} is {len(found)} types: {', '.join(found)}" for name,
                   found in sorted(places.items()) if len(found) > 1]
