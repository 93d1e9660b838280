#!/usr/bin/env python3
"""The house's own rules, checked by reading the sources. Each rule also shows that it fails on a tree that breaks it.

usage: house.py RULE SOURCE_FOLDER      (RULE: floors, terms, types, includes, sizes, readmes, paths, checklists, listings, prose)
"""
import re
import sys
import tempfile
from pathlib import Path

INCLUDE = re.compile(r'^\s*#include "([a-z_]+)/', re.MULTILINE)

# Names of the standard library (ranges:: as well), by the header that has them. Another standard header may declare them, too,
# with one compiler and not with the next: GCC 12 finds std::clamp without <algorithm>, GCC 14 does not.
STANDARD_HEADERS = {
    "algorithm": """adjacent_find all_of any_of binary_search clamp copy copy_backward copy_if copy_n count count_if equal equal_range
        fill fill_n find find_end find_first_of find_if find_if_not for_each generate generate_n includes inplace_merge
        is_sorted lexicographical_compare lower_bound make_heap max max_element merge min min_element minmax minmax_element mismatch
        next_permutation none_of nth_element partial_sort partition partition_point pop_heap push_heap remove_copy remove_copy_if
        remove_if replace replace_if reverse rotate search set_difference set_intersection set_union shuffle sort sort_heap
        stable_partition stable_sort swap_ranges transform unique upper_bound""",
    "numeric": "accumulate exclusive_scan gcd inclusive_scan inner_product iota lcm midpoint partial_sum reduce",
    "array": "array to_array",
    "atomic": "atomic atomic_bool atomic_flag",
    "bit": "bit_cast bit_ceil bit_floor bit_width countl_zero countr_zero endian has_single_bit popcount",
    "charconv": "from_chars to_chars",
    "chrono": "chrono::[a-z_]+",
    "cstdio": "fclose fflush fopen fprintf fputs fread fseek fwrite printf puts snprintf",
    "cstdlib": "abort exit getenv strtod strtof strtol strtoul",
    "cstring": "memchr memcmp memcpy memmove memset strchr strcmp strlen strncmp strstr",
    "deque": "deque", "filesystem": "filesystem::[a-z_]+", "fstream": "fstream ifstream ofstream",
    "functional": "bind_front function greater hash less plus", "future": "async future promise",
    "limits": "numeric_limits", "map": "map multimap",
    "memory": "make_shared make_unique shared_ptr unique_ptr weak_ptr", "mutex": "lock_guard mutex scoped_lock unique_lock",
    "numbers": "numbers::[a-z_0-9]+", "optional": "make_optional nullopt optional",
    "random": "mt19937 mt19937_64 normal_distribution uniform_int_distribution uniform_real_distribution",
    "regex": "regex regex_match regex_replace regex_search smatch", "set": "multiset set", "span": "as_bytes span",
    "sstream": "istringstream ostringstream stringstream", "string": "getline stod stof stoi string to_string",
    "string_view": "string_view", "thread": "jthread this_thread thread", "tuple": "make_tuple tie tuple",
    "unordered_map": "unordered_map", "unordered_set": "unordered_set", "utility": "exchange",
    "variant": "get_if holds_alternative monostate variant visit", "vector": "vector",
}

# Phrases that we do not use, each with what we write instead. Prose is read without regard to line ends.
PHRASES = {
    r"anew": "again",
    r"(?:is|are|be|been|was|were) told from": "is distinguished from",
    r"(?:tell|told|tells) apart": "distinguish",
    r"(?:is|are|be|been|was|were) asked(?: for)?": "is queried, is requested, or the name of the function that is called",
    r"stands? in (?:for|the place of)": "replaces",
    r"has it not|have it not|knows? it not": "does not have it",
    r"wherefrom|wherein|whereof|whither|whence": "from where, in which",
    r"farness": "depth, distance",
    r"[Mm]irrors? of (?:the|[a-z]+::|`)|Mirror:": "keep in sync with",
    r"by and by|ere|lest|thereof|therein|oft": "plain English",
    r"with no word|without a word": "silently",
    r"keeps? (?:its|their|the) (?:word|promise)": "stays below the bound",
    r"as ever": "unchanged",
    r"[Ww]hoever|[Ww]homever": "the code that, callers that",
    r"goes? by (?:the|its|their)": "depends on, uses",
    r"takes? (?:its|their) place": "replaces",
    r"(?:behind|before|passes|for) the eye": "the camera",
}

# A comment does not open with a free relative clause ("What a pixel needs."): a type is named by a noun, a function by its verb.
FREE_RELATIVE = re.compile(r"(?:What|Which|Where(?![^.]*,)|Who|Whom|Whose|Whether|How (?:many|much|far|long|often|wide|near))\b(?![^.]*\?)")


def sources(folder: Path, *suffixes: str):
    return sorted(p for p in folder.rglob("*") if p.suffix in suffixes and p.is_file() and ".venv" not in p.parts)


def links_of(root: Path) -> dict[str, set[str]]:
    """Folder of src/ → the folders that its sr_library line links, public and private."""
    links = {}
    for file in sorted((root / "src").glob("*/CMakeLists.txt")):
        call = re.search(r"sr_library\((\w+)(.*?)\)", file.read_text(), re.DOTALL)
        if call:
            links[call.group(1)] = set(re.findall(r"\bsr_(\w+)", call.group(2))) - {"compile_settings", "glad"}
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


def types(root: Path) -> list[str]:
    """No two headers of src/ define types of one name, but for those that gl/ names after OpenGL's objects."""
    defined = re.compile(r"^(?:struct|class|enum class|enum) (\w+)\b(?=[^;{]*\{)", re.MULTILINE)
    headers = {}
    for file in sources(root / "src", ".hpp"):
        if file.relative_to(root / "src").parts[0] != "gl":
            for name in defined.findall(file.read_text()):
                headers.setdefault(name, []).append(str(file.relative_to(root)))
    return [f"{name}: {', '.join(files)}: rename all but one" for name, files in headers.items() if len(files) > 1]


def included_by(root: Path, file: Path, known: dict[Path, set[str]]) -> set[str]:
    """The standard headers that a file includes, itself or by headers of ours."""
    if file not in known:
        known[file] = set()
        text = file.read_text()
        known[file] |= set(re.findall(r"^\s*#include <([a-z_]+)>", text, re.MULTILINE))
        for name in re.findall(r'^\s*#include "([^"]+)"', text, re.MULTILINE):
            for folder in (file.parent, root / "src", root / "tests", root / "tools"):
                if (folder / name).is_file():
                    known[file] |= included_by(root, (folder / name).resolve(), known)
                    break
    return known[file]


def includes(root: Path) -> list[str]:
    """A name of the standard library comes from a header that the file, or a header of ours that it includes, names."""
    header_of = {name: header for header, names in STANDARD_HEADERS.items() for name in names.split()}
    used = re.compile(r"\bstd::(?:ranges::)?(" + "|".join(sorted(header_of, key=len, reverse=True)) + r")\b(?!::)")
    broken, known = [], {}
    for file in (f for folder in ("src", "tests", "tools") for f in sources(root / folder, ".cpp", ".hpp")):
        code = re.sub(r"//[^\n]*", "", file.read_text())
        there = included_by(root, file.resolve(), known)
        lacking = {}
        for name in used.findall(code):
            header = header_of.get(name) or next(h for n, h in header_of.items() if re.fullmatch(n, name))
            if header not in there:
                lacking.setdefault(header, name)
        broken += [f"{file.relative_to(root)}: std::{name} without #include <{header}>" for header, name in lacking.items()]
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


def paths(root: Path) -> list[str]:
    """A file or folder of ours that a README, CONTRIBUTING.md or a comment names from the root on is there."""
    named = re.compile(r"`((?:assets|examples|shaders|src|tests|tools)/[A-Za-z0-9_./-]+)`")
    in_comment = re.compile(r"\b((?:assets|examples|shaders|src|tests|tools)/[A-Za-z0-9_./-]+\.(?:cpp|hpp|glsl|frag|vert|py|json|md))\b")
    broken = []
    for file in sorted(root.rglob("*.md")):
        if {"build", ".venv", "out", "node_modules"} & set(file.relative_to(root).parts) or file.name == "CHANGELOG.md":
            continue
        for path in named.findall(file.read_text()):
            pattern = path.rstrip("/").replace("NAME", "*").replace("aN-name", "a[0-9]-*")
            if not any(found for folder in (root, file.parent) for found in folder.glob(pattern)):
                broken.append(f"{file.relative_to(root)}: {path}: there is no such file")
    for folder in ("shaders", "src", "tests", "tools"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in {".cpp", ".hpp", ".glsl", ".frag", ".vert"}:
                continue
            for line, comment in comment_blocks(file.read_text(), "//+"):
                for path in in_comment.findall(comment):
                    if not re.search(r"NAME|aN-", path) and not (root / path).exists():
                        broken.append(f"{file.relative_to(root)}:{line}: {path}: there is no such file")
    return broken


def checklists(root: Path) -> list[str]:
    """Each checklist of CONTRIBUTING.md names files, and the names and tests in it are those of the sources."""
    sources_text = "\n".join(file.read_text() for folder in ("src", "shaders", "tests", "tools")
                             for file in sources(root / folder, ".cpp", ".hpp", ".glsl", ".frag", ".txt", ".py") if file.name != "house.py")
    words = set(re.findall(r"\w+", sources_text))
    broken = []
    for title, text in re.findall(r"^## (A new .*?)\n(.*?)(?=^## |\Z)", (root / "CONTRIBUTING.md").read_text(), re.DOTALL | re.MULTILINE):
        if not re.search(r"`(?:assets|shaders|src|tests|tools)/|\]\(src/", text):
            broken.append(f"CONTRIBUTING.md: {title}: names no file")
        for code in re.findall(r"`([^`]+)`", text):
            test = re.search(r"\b(?:unit|law)(?:\.\w+)+", code)
            name = re.fullmatch(r"(?:\w+::)?(\w*(?:[a-z]_[a-z]|[A-Z][a-z]|[a-z][A-Z])\w*)(?:\(\))?", code)
            if test and test.group() not in sources_text:
                broken.append(f"CONTRIBUTING.md: {title}: {test.group()}: there is no such test")
            if name and "NAME" not in code and name.group(1) not in words:
                broken.append(f"CONTRIBUTING.md: {title}: {code}: there is no such name")
    return broken


def comment_blocks(text: str, marks: str):
    """(line, text) of each block of whole-line comments, and of comments that end a line of code."""
    block, start = [], 0
    for number, line in enumerate(text.splitlines() + [""], 1):
        whole = re.match(rf"\s*(?:{marks})\s?(.*)", line)
        if whole:
            start = start if block else number
            block.append(whole.group(1))
            continue
        if block:
            yield start, " ".join(block)
            block = []
        trailing = re.search(rf"\S.*?\s(?:{marks})\s(.*)", line)
        if trailing:
            yield number, trailing.group(1)


def prose_of(root: Path):
    """(file, line, text, is a comment of our code) of everything that is written for people."""
    for file in sorted(root.rglob("*.md")):
        if file.relative_to(root).parts[0] not in ("build", ".venv", "out", "shared") and file.name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md"):
            text = re.sub(r"```.*?```|^ {4,}[^\n]*", lambda m: "\n" * m.group().count("\n"), file.read_text(), flags=re.DOTALL | re.MULTILINE)
            line = 1
            for paragraph in re.split(r"(\n\s*\n)", text):
                if paragraph.strip():
                    yield file, line, re.sub(r"`[^`]*`", "``", paragraph), False
                line += paragraph.count("\n")
    for folder in ("src", "shaders", "tests", "tools"):
        for file in sources(root / folder, ".cpp", ".hpp", ".glsl", ".frag", ".vert"):
            yield from ((file, line, text, True) for line, text in comment_blocks(file.read_text(), "///?"))
    for file in sorted((root / "tools").rglob("*")):
        if file.is_file() and not {".venv", "__pycache__"} & set(file.parts) and file.suffix in ("", ".py"):
            text = file.read_text(errors="replace")
            for help_text in re.finditer(r'^"""(.*?)"""', text, re.DOTALL | re.MULTILINE):
                yield file, text[: help_text.start()].count("\n") + 1, help_text.group(1), False


def prose(root: Path) -> list[str]:
    """Comments, READMEs and help use the field's words and plain sentences."""
    phrases = [(re.compile(rf"(?<![\w`])(?:{was})(?!\w)"), instead) for was, instead in PHRASES.items()]
    broken = []
    for file, line, text, is_comment in prose_of(root):
        path = file.relative_to(root)
        flat = re.sub(r"\s+", " ", text)
        for phrase, instead in phrases:
            found = phrase.search(flat)
            if found:
                broken.append(f"{path}:{line}: \"{found.group()}\": write \"{instead}\"")
        if is_comment and FREE_RELATIVE.match(flat):
            broken.append(f"{path}:{line}: \"{flat[:60]}\": name the thing, or start with a verb")
    return broken


def listings(root: Path) -> list[str]:
    """The lines of a GLSL listing that names its file (```glsl, // FILE) are lines of that file, in this order."""
    broken = []
    for readme in sorted((root / "shaders").rglob("README.md")):
        for name, lines in re.findall(r"^```glsl\n// (\S+)\n(.*?)^```", readme.read_text(), re.DOTALL | re.MULTILINE):
            file = readme.parent / name
            if not file.is_file() or lines not in file.read_text():
                broken.append(f"{readme.relative_to(root)}: the listing of {name} is not in that file")
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
    types: (1, {"src/core/a.hpp": "struct A {\n    struct C {};\n};\nclass B;\n", "src/scene/a.hpp": "class A final : B {\n};\nstruct C {};\n",
                "src/scene/b.hpp": "struct B {};\nenum D : int;\n", "src/gl/a.hpp": "struct B {};\nenum class D { a };\n"}),
    sizes: (3, {"shaders/brdf/a.glsl": "\n" * 121, "src/core/a.cpp": "\n" * 501, "tools/a.py": "\n" * 501,
                "src/core/b.hpp": "\n" * 500}),
    includes: (2, {"src/core/a.hpp": "#include <vector>\n", "src/core/b.hpp": '#include "core/a.hpp"\n#include <algorithm>\n',
                   "src/core/a.cpp": '#include "core/a.hpp"\nstd::vector<int> a{std::max(1, 2)}; // std::min\n',
                   "tests/support/a.hpp": "#include <optional>\n",
                   "tests/a.cpp": '#include "core/b.hpp"\n#include "support/a.hpp"\nbool a = std::ranges::none_of(b, std::nullopt);\n',
                   "tools/a.cpp": "std::chrono::seconds a;\n"}),
    readmes: (1, {"src/core/a.cpp": "", "src/gl/a.cpp": "", "src/README.md": "gl/ is named"}),
    checklists: (3, {"CONTRIBUTING.md": "# All\n`no_such`\n## A new a\n1. `make_a` in `src/a.cpp`, `ctest -R unit.a`\n## A new b\n1. `make_b()`, `law.b.a`, NAME\n",
                     "src/a.cpp": "int make_a();\n", "tests/a.cpp": "\"unit.a.is_right\"\n"}),
    paths: (3, {"CONTRIBUTING.md": "`src/core/a.cpp` `src/core/b.cpp` `src/NAME.cpp` `src/core/NAME.cpp`", "src/README.md": "`src/` `tests/law/`", "src/core/a.cpp": ""}),
    listings: (2, {"shaders/README.md": "```glsl\n// a.glsl\nint a;\nint b;\n```\n```glsl\n// a.glsl\nint b;\n```\n```glsl\n// b.glsl\n```\n",
                   "shaders/a.glsl": "int a;\n\nint b;\n"}),
    prose: (5, {"README.md": "It is made\nanew.\n\n    told from\n`anew`", "src/core/a.hpp": "// What a pixel needs.\nint a; // Whose is it?\n",
                "src/core/b.cpp": "int a; // farness\n// Which one?\n", "shaders/brdf/a.glsl": "// A term\n// which is asked.\n",
                "tools/a": '#!/usr/bin/env python3\n"""Makes it\nanew."""\n'}),
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
