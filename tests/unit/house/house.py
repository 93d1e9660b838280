#!/usr/bin/env python3
"""The house's own rules, checked by reading the sources. Each rule also shows that it fails on a tree that breaks it.

usage: house.py RULE SOURCE_FOLDER      (RULE: floors, terms, sizes, readmes)
"""
import re
import sys
import tempfile
from pathlib import Path

INCLUDE = re.compile(r'^\s*#include "([a-z_]+)/', re.MULTILINE)


def sources(folder: Path, *suffixes: str):
    return sorted(p for p in folder.rglob("*") if p.suffix in suffixes and p.is_file() and ".venv" not in p.parts)


def links_of(root: Path) -> dict[str, set[str]]:
    """Folder of src/ → the folders that its sr_library line links, public and private."""
    links = {}
    for file in sorted((root / "src").glob("*/CMakeLists.txt")):
        call = re.search(r"sr_library\((\w+)(.*?)\)", file.read_text(), re.DOTALL)
        if call:
            links[call.group(1)] = set(re.findall(r"\bsr_(\w+)", call.group(2))) - {"settings", "glad"}
    return links


def reachable(name: str, links: dict[str, set[str]]) -> set[str]:
    seen, todo = set(), [name]
    while todo:
        folder = todo.pop()
        if folder not in seen:
            seen.add(folder)
            todo.extend(links.get(folder, ()))
    return seen


def floors(root: Path) -> list[str]:
    """A folder includes only itself and what it links, and no two folders link each other."""
    links = links_of(root)
    folders = {p.name for p in (root / "src").iterdir() if p.is_dir()}
    broken = [f"src/{a} and src/{b} link each other" for a in links for b in links[a] if a in reachable(b, links)]
    for file in sources(root / "src", ".cpp", ".hpp"):
        folder = file.relative_to(root / "src").parts[0]
        for included in INCLUDE.findall(file.read_text()):
            if included in folders and included not in reachable(folder, links):
                broken.append(f"{file.relative_to(root)}: includes {included}/, which {folder}/ does not link")
    return broken


def terms(root: Path) -> list[str]:
    """brdf/, light/ and visibility/ never include one another."""
    rooms = {"brdf", "light", "visibility"}
    broken = []
    for file in sources(root / "shaders", ".glsl"):
        room = file.relative_to(root / "shaders").parts[0]
        for included in INCLUDE.findall(file.read_text()):
            if room in rooms and included in rooms and included != room:
                broken.append(f"{file.relative_to(root)}: {room}/ includes {included}/")
    return broken


def sizes(root: Path) -> list[str]:
    """C++ and Python files have at most 500 lines, GLSL files 120."""
    broken = []
    for folder in ("src", "shaders", "tests", "tools"):
        for file in sources(root / folder, ".cpp", ".hpp", ".py", ".glsl", ".vert", ".frag"):
            most = 120 if file.suffix in {".glsl", ".vert", ".frag"} else 500
            lines = len(file.read_text().splitlines())
            if lines > most:
                broken.append(f"{file.relative_to(root)}: {lines} lines, at most {most}: divide it")
    return broken


def readmes(root: Path) -> list[str]:
    """A folder has a README.md, or the README.md above it names the folder."""
    broken = []
    folders = [root / "assets" / "scenes"] + [root / top for top in ("src", "shaders", "tests", "tools")]
    folders += [p for top in ("src", "shaders", "tests", "tools") for p in sorted((root / top).glob("*/"))]
    for folder in folders:
        if not folder.is_dir() or folder.name.startswith((".", "__")) or (folder / "README.md").is_file():
            continue
        above = folder.parent / "README.md"
        if not (above.is_file() and f"{folder.name}/" in above.read_text()):
            broken.append(f"{folder.relative_to(root)}: has no README.md, and none above names it")
    return broken


# For each rule, files of a tree that breaks it in as many places as the number says.
BAD_TREES = {
    floors: (3, {"src/core/CMakeLists.txt": "sr_library(core SOURCES a.cpp)",
                 "src/gl/CMakeLists.txt": "sr_library(gl SOURCES a.cpp\n LINKS sr_core)",
                 "src/gl/a.cpp": '#include "core/error.hpp"\n',
                 "src/core/a.cpp": '#include "gl/context.hpp"\n  #include "viewer/window.hpp"\n',
                 "src/viewer/a.cpp": '#include "core/error.hpp"\n'}),
    terms: (2, {"shaders/brdf/a.glsl": '#include "light/sample_light.glsl"\n#include "base/math.glsl"\n',
                "shaders/visibility/a.glsl": '#include "brdf/f_r.glsl"\n'}),
    sizes: (3, {"shaders/brdf/a.glsl": "\n" * 121, "src/core/a.cpp": "\n" * 501, "tools/a.py": "\n" * 501,
                "src/core/b.hpp": "\n" * 500}),
    readmes: (1, {"src/core/a.cpp": "", "src/gl/a.cpp": "", "src/README.md": "gl/ is named"}),
}


def finds_what_is_broken(rule) -> bool:
    expected, files = BAD_TREES[rule]
    with tempfile.TemporaryDirectory() as scratch:
        for name, text in files.items():
            file = Path(scratch, name)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        return len(rule(Path(scratch))) == expected


def main() -> int:
    rule = {r.__name__: r for r in BAD_TREES}[sys.argv[1]]
    if not finds_what_is_broken(rule):
        print(f"{sys.argv[1]}: does not find what is broken in a tree that was made for it: mend the rule")
        return 1
    broken = rule(Path(sys.argv[2]))
    print("\n".join(broken) or f"{sys.argv[1]}: {rule.__doc__} It is so.")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
