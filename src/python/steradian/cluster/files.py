"""What travels to workers: scenes with their textures, folders, submissions."""
from __future__ import annotations

import hashlib
import json
import os
import stat
import struct
from pathlib import Path
from typing import Any, Iterable, Iterator

from .failure import Failure

# A path, a kind ("file", "link", …, or a size beyond what is read), and a content.
Entry = tuple[bytes, "str | int", bytes]
Bundle = tuple[str, list[Entry]]  # a digest and its files

MOST_BYTES = 8 << 30  # of a bundle

# What src/assignment/archive.hpp reads of a submission; of anything else the name is enough.
MOST_DEPTH, MOST_FILES, MOST_TEXT, MOST_ARCHIVE = 8, 10_000, 1 << 20, 64 << 20


def bundle_of(root: Path, files: Iterable[Path]) -> Bundle:
    """(digest, entries) of files below a folder, folders among them with all that they hold."""
    entries: list[Entry] = []
    size = 0
    found: set[Path] = set()
    for file in files:
        found |= {f for f in file.rglob("*") if f.is_file()} if file.is_dir() else {file}
    for file in sorted(found):
        size += file.stat().st_size
        if size > MOST_BYTES:
            raise Failure(f"{file}: more than {MOST_BYTES >> 30} GiB would travel to each worker: leave something out")
        entries.append((os.fsencode(file.relative_to(root)), "file", file.read_bytes()))
    digest = hashlib.sha256()
    for path, kind, content in entries:
        digest.update(f"{len(path)} {len(content)}\n".encode() + path + content)
    return digest.hexdigest(), entries


def folder_bundle(folder: Path) -> Bundle:
    """A folder with all that it holds, under its own name."""
    folder = folder.resolve()
    return bundle_of(folder.parent, [folder])


def texts_in(value: Any) -> Iterator[str]:
    """All texts of a JSON value."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for part in value.values():
            yield from texts_in(part)
    elif isinstance(value, list):
        for part in value:
            yield from texts_in(part)


def json_of(file: Path) -> Any:
    """The JSON of a .gltf, a .glb or a .json file; None if it has none. The program tells what is wrong with it."""
    data = file.read_bytes()
    try:
        if data[:4] == b"glTF":
            data = data[20:20 + struct.unpack("<I", data[12:16])[0]]
        return json.loads(data)
    except (ValueError, struct.error):
        return None


def named_files(file: Path) -> set[Path]:
    """A file and all that its JSON names: buffers, textures, IES files, environments, scenes of a suite."""
    found: set[Path] = set()
    waiting = [file]
    while waiting:
        one = Path(os.path.abspath(waiting.pop()))
        if one in found:
            continue
        found.add(one)
        if one.suffix not in (".gltf", ".glb", ".json"):
            continue
        for text in texts_in(json_of(one)):
            if 0 < len(text) < 1000 and "\0" not in text and not text.startswith("data:"):
                for name in {text, text.replace("%20", " ")}:
                    if (one.parent / name).is_file():
                        waiting.append(one.parent / name)
    return found


def submission_entries(path: Path) -> list[Entry]:
    """A submission as entries: what is read of it whole, and the rest by name, kind and size, so that it is refused as here."""
    name = os.fsencode(path.name)
    entries: list[Entry] = []

    def add(file: Path, within: bytes) -> None:
        mode = os.lstat(file).st_mode
        if stat.S_ISLNK(mode):
            entries.append((within, "link", os.fsencode(os.readlink(file))))
        elif stat.S_ISDIR(mode):
            entries.append((within, "folder", b""))
        elif not stat.S_ISREG(mode):
            entries.append((within, "other", b""))
        else:
            most = MOST_ARCHIVE if file.suffix == ".zip" else MOST_TEXT if file.suffix == ".glsl" or file.name == "assignment.json" else -1
            size = file.stat().st_size
            with open(file, "rb") as stream:
                entries.append((within, "file", stream.read()) if size <= most else (within, size, b""))

    def walk(folder: Path, within: bytes, depth: int) -> None:
        with os.scandir(folder) as found:
            for entry in found:
                if len(entries) > MOST_FILES + 1:
                    return
                inner = within + b"/" + os.fsencode(entry.name)
                add(folder / entry.name, inner)
                if entry.is_dir(follow_symlinks=False) and depth < MOST_DEPTH:
                    walk(folder / entry.name, inner, depth + 1)

    add(path, name)
    if path.is_dir():
        walk(path, name, 0)
    return entries
