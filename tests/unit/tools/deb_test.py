#!/usr/bin/env python3
"""The .deb that cpack makes: its fields and its files.

usage: deb_test.py CPACK BUILD_FOLDER SCRATCH_FOLDER      (exit status 77, a skip, where there is no dpkg-deb)
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[3]
FILES = {
    "usr/bin/steradian", "usr/lib/steradian/modules/sr_image_oiio.so", "usr/share/steradian/scenes/default.gltf",
    "usr/share/steradian/scenes/downlight.ies", "usr/share/steradian/assignments/a1-light/assignment.json",
    "usr/share/steradian/extras.schema.json", "usr/share/cmake/Steradian/SteradianConfig.cmake", "usr/share/man/man1/steradian.1.gz",
    "usr/share/man/man1/steradian-golden-run.1.gz", "usr/share/bash-completion/completions/steradian",
    "usr/share/zsh/vendor-completions/_steradian", "usr/share/fish/vendor_completions.d/steradian.fish",
    "usr/share/applications/steradian.desktop", "usr/share/icons/hicolor/scalable/apps/steradian.svg",
    "usr/share/mime/packages/steradian.xml", "usr/share/doc/steradian/copyright", "usr/share/doc/steradian/changelog.gz",
    "usr/share/doc/steradian/manual.html",
}


def output(*words):
    return subprocess.run(list(map(str, words)), check=True, capture_output=True, text=True).stdout


def main():
    cpack, build, scratch = sys.argv[1], *map(Path, sys.argv[2:4])
    if not shutil.which("dpkg-deb") or not shutil.which("dpkg-shlibdeps"):
        print("dpkg-deb or dpkg-shlibdeps is not installed: nothing is packed")
        return 77
    shutil.rmtree(scratch, ignore_errors=True)
    output(cpack, "-G", "DEB", "--config", build / "CPackConfig.cmake", "-B", scratch, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip")
    (package,) = scratch.glob("*.deb")
    fields = dict(re.findall(r"^([A-Z][A-Za-z-]+): (.*)$", output("dpkg-deb", "-f", package), re.MULTILINE))
    assert package.name == f"steradian_{fields['Version']}_{fields['Architecture']}.deb", package.name
    assert (fields["Package"], fields["Section"]) == ("steradian", "graphics"), fields
    assert re.fullmatch(r"Steradian developers <\S+@\S+>", fields["Maintainer"]), fields
    for library in ("libc6", "libegl1", "libgl1-mesa-dri", "libglfw3", "libopenimageio"):  # by the program, by hand, by the module
        assert re.search(rf"(^|, ){re.escape(library)}", fields["Depends"]), (library, fields["Depends"])
    assert not re.search(r"\b(post|pre)(inst|rm)\b", output("dpkg-deb", "-I", package)), "nothing is run at an installation"
    if "VERSION_CODENAME=bookworm" in Path("/etc/os-release").read_text():  # the README names that release's packages
        named = re.search(r"On Debian 12 it needs (.*?);", (SOURCE / "src/python/README.md").read_text(), re.DOTALL)[1]
        needed = {part.split()[0] for part in fields["Depends"].split(", ")} - {"libc6", "libgcc-s1", "libstdc++6"}
        assert set(re.findall(r"\bz?lib[a-z0-9.+-]+", named)) == needed, needed
    listed = [line.split(maxsplit=5) for line in output("dpkg-deb", "-c", package).splitlines()]
    files = {name.removeprefix("./"): mode for mode, _, _, _, _, name in listed}
    assert FILES <= set(files), FILES - set(files)
    assert {owner for _, owner, *_ in listed} == {"root/root"}
    for name, mode in files.items():
        assert mode[8] != "w", f"anyone may write {name}"
        assert name in ("", "usr/") or re.match(r"usr/(bin|lib|share)/", name), name
        assert not re.search(r"/(build|scratch|__pycache__)/", name), name
    print(f"{package.name}: {len(files)} files and folders, {package.stat().st_size / 1e6:.1f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
