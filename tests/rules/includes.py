"""Checks who includes whom: includes.py [ROOT] prints what breaks the rules.

- A file includes only headers of its own library and of those that this library links, directly or through others.
- Libraries link only what comes before them: the modules of core in the order of core/CMakeLists.txt (docs/design.md
  lists them in that order too), then gl, then the rooms of the application in the order of cli/CMakeLists.txt, then the rest
  of cli, then cli/library.
- Folders do not include each other in a cycle, nor do files: a header and its source are one file for that.
- core, gl, the application and cli/library use neither the library for the command line nor the one for logs.
- Who observes, composes or draws sees the plan, not the job that it was made of.
- Headers that other programs include use the standard library and each other alone, and only cli/library uses them.
"""

import collections
import itertools
import pathlib
import re
import sys

FLOORS = ("core", "gl", "cli")
PROCESS_HEADERS = ("CLI/", "spdlog/")
APPLICATION = ("cli/plan", "cli/observe", "cli/compose", "cli/draw", "cli/excerpt", "cli/write", "cli/app")
NO_PROCESS = ("core", "gl", *APPLICATION, "cli/library")
VERBS = ("cli/observe", "cli/compose", "cli/draw")
OF_A_JOB = ("cli/plan/settings.h", "cli/plan/input.h", "cli/plan/make_plan.h")
PUBLIC = "cli/library/vvr"
OF_C = {"stddef.h", "stdint.h"}  # the headers of C that a public header may include


def sources(root, floors=FLOORS, endings=(".h", ".cpp")):
    """The path and the text of each file in these folders."""
    for floor in floors:
        for file in sorted((root / floor).rglob("*")):
            if file.suffix in endings and file.is_file():
                yield file.relative_to(root), file.read_text(encoding="utf-8")


def commands(file):
    """The commands of a CMake file as pairs of a name and its arguments."""
    text = re.sub(r"#.*", "", file.read_text(encoding="utf-8"))
    return [(name, arguments.split()) for name, arguments in re.findall(r"(\w+)\(([^()]*)\)", text)]


class House:
    """The libraries that the CMake files declare, and the includes of their sources."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.library_of = {}  # by folder
        self.home = {}  # the folder of a library's first source
        self.links = collections.defaultdict(set)
        self.program_of = {}  # by source of an executable; nothing includes it, so no cycle goes through it
        for floor in FLOORS:
            for file in sorted((self.root / floor).rglob("CMakeLists.txt")):
                self._read(file)
        modules = [arguments[1:] for name, arguments in commands(self.root / "core/CMakeLists.txt") if name == "foreach"]
        self.modules = [f"core/{module}" for module in itertools.chain(*modules)]
        self.order = [*self.modules, "gl", *APPLICATION, "cli", "cli/library"]
        self.includes = list(self._includes())

    def _read(self, file):
        found = {}  # by the variable of a file(GLOB ...)
        for name, arguments in commands(file):
            if name == "file" and arguments[0] == "GLOB":
                found["${" + arguments[1] + "}"] = [source.name for source in sorted(file.parent.glob(arguments[-1]))]
                continue
            arguments = list(itertools.chain(*(found.get(word, [word]) for word in arguments)))
            if name == "vvr_module":
                modules = itertools.takewhile(lambda word: word != "LIBRARIES", self._after(arguments, "MODULES"))
                self._declare(file.parent, f"vvr_{arguments[0]}", arguments, [f"vvr_{module}" for module in modules])
            elif name in ("add_library", "target_sources", "target_link_libraries", "add_executable"):
                links = [word for word in arguments[1:] if word.startswith("vvr_")]
                self._declare(file.parent, arguments[0], arguments, links, name == "add_executable")

    @staticmethod
    def _after(words, key):
        return words[words.index(key) + 1:] if key in words else []

    def _declare(self, folder, target, words, links, program=False):
        self.links[target].update(links)
        for word in words:
            if word.endswith(".cpp") and "$" not in word:
                source = (folder / word).relative_to(self.root)
                if program:
                    self.program_of[source] = target
                else:
                    self.home.setdefault(target, str(source.parent))
                    self.library_of.setdefault(str(source.parent), target)

    def _includes(self):
        """File, line number, the name in the include, and the folder of one of our headers (else None)."""
        for file, text in sources(self.root):
            for number, line in enumerate(text.splitlines(), 1):
                if found := re.match(r'#\s*include\s+(["<])([^">]+)', line):
                    header = pathlib.Path(found[2])
                    ours = found[1] == '"' and len(header.parts) > 1
                    yield file, number, found[2], str(header.parent) if ours else None

    def reach(self, target):
        """The target and all that it links, directly or through others."""
        found, left = set(), [target]
        while left:
            each = left.pop()
            if each not in found:
                found.add(each)
                left += self.links[each]
        return found

    def rank(self, folder):
        """The place of the module that a folder belongs to, from below."""
        return max((i for i, module in enumerate(self.order) if pathlib.Path(folder).is_relative_to(module)),
                   key=lambda i: len(self.order[i]))


def wrong_includes(house):
    for file, number, header, folder in house.includes:
        place = f"{file}:{number}: includes {header}"
        if folder is None:
            if header.startswith(PROCESS_HEADERS) and any(file.is_relative_to(module) for module in NO_PROCESS):
                yield f"{place}, which only the rest of cli may use"
            continue
        if header in OF_A_JOB and str(file.parent) in VERBS:
            yield f"{place}: {file.parent} sees cli/plan/plan.h, not the job"
        mine, other = house.program_of.get(file, house.library_of.get(str(file.parent))), house.library_of.get(folder)
        if mine is None or other is None:
            yield f"{place}: no library has sources in {file.parent if mine is None else folder}"
        elif other not in house.reach(mine):
            yield f"{place} of {other}, which {mine} doesn't link"


def wrong_public(house):
    for file, number, header, _ in house.includes:
        place = f"{file}:{number}: includes {header}"
        public = header.startswith("vvr/")
        if public and not file.is_relative_to("cli/library"):
            yield f"{place}, which is for other programs"
        elif public and not (house.root / "cli/library" / header).is_file():
            yield f"{place}, which is not in {PUBLIC}"
        elif not public and file.is_relative_to(PUBLIC) and ("/" in header or "." in header) and header not in OF_C:
            yield f"{place}, which other programs don't have"


def wrong_links(house):
    for library, home in sorted(house.home.items()):
        for other in sorted(house.links[library]):
            if other in house.home and house.rank(house.home[other]) > house.rank(home):
                yield f"{library} in {home} links {other} in {house.home[other]}, which comes after it"


def cycles_among(edges):
    """For each set of nodes of a cycle the shortest way around it, once. Each node has those it leads to, each with its place."""
    found = {}
    for begin in sorted(edges):
        ways, known = collections.deque([[begin]]), set()
        while ways:
            way = ways.popleft()
            for node in edges.get(way[-1], {}):
                if node == begin:
                    found.setdefault(frozenset(way), [*way, begin])
                elif node not in known:
                    known.add(node)
                    ways.append([*way, node])
    for way in found.values():
        yield f"cycle {' -> '.join(way)}: {', '.join(edges[one][other] for one, other in itertools.pairwise(way))}"


def cycles(house):
    """Among folders."""
    edges = collections.defaultdict(dict)
    for file, number, _, folder in house.includes:
        if folder not in (None, str(file.parent)) and file not in house.program_of:
            edges[str(file.parent)].setdefault(folder, f"{file}:{number}")
    yield from cycles_among(edges)


def cycles_of_files(house):
    """Among the files of a folder."""
    edges = collections.defaultdict(dict)
    for file, number, header, folder in house.includes:
        mine, other = str(file.with_suffix("")), str(pathlib.Path(header).with_suffix(""))
        if folder == str(file.parent) and mine != other and file not in house.program_of:
            edges[mine].setdefault(other, f"{file}:{number}")
    yield from cycles_among(edges)


def wrong_docs(house):
    """docs/design.md lists the modules of core in another order, or other modules."""
    text = (house.root / "docs/design.md").read_text(encoding="utf-8")
    listed = re.findall(r"^\| `(core/\w+)/` \|", text, flags=re.MULTILINE)
    if listed != house.modules:
        yield f"docs/design.md lists {listed}, core/CMakeLists.txt {house.modules}"


def complaints(root):
    house = House(root)
    return [text for rule in (wrong_includes, wrong_public, wrong_links, cycles, cycles_of_files, wrong_docs) for text in rule(house)]


if __name__ == "__main__":
    said = complaints(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2])
    sys.exit("\n".join(said) if said else 0)
