#!/usr/bin/env python3
"""First contact with the program: alone on a terminal, its bundled scenes, what it says of the machine and of itself.

usage: reach_test.py STERADIAN SCENES_FOLDER TEST_NAME     (TEST_NAME is a method of FirstContact below)
"""
import json
import math
import os
import pty
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STERADIAN = SCENES = None


def run(*arguments, **options):
    return subprocess.run([STERADIAN, *map(str, arguments)], capture_output=True, text=True, timeout=250, **options)


class FirstContact(unittest.TestCase):
    def on_terminal(self, *arguments):
        """Returns the exit status and what the program prints on a terminal."""
        ours, terminal = pty.openpty()
        program = subprocess.Popen([STERADIAN, *arguments], stdin=subprocess.DEVNULL, stdout=terminal, stderr=terminal)
        os.close(terminal)
        text = b""
        try:
            while part := os.read(ours, 4096):
                text += part
        except OSError:  # Linux reports the end of a terminal so
            pass
        os.close(ours)
        return program.wait(timeout=100), text.decode().replace("\r\n", "\n")

    def test_alone_on_a_terminal_it_says_what_it_is(self):
        status, text = self.on_terminal()
        self.assertEqual(status, 0, text)
        self.assertTrue(text.startswith("Steradian "), text)
        commands = [line.split()[1] for line in text.splitlines() if line.startswith("  steradian ")]
        self.assertEqual(len(commands), 5, text)
        for command in commands:
            self.assertEqual(run(command, "--help").returncode, 0, command)
        self.assertTrue(text.endswith(f", in {SCENES.resolve()}\n"), text)

    def test_alone_in_a_script_it_is_a_usage_error(self):
        result = run()
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("--help", result.stderr)
        self.assertEqual(self.on_terminal("--frobnicate")[0], 2)

    def test_samples_are_the_bundled_scenes(self):
        listed = json.loads(run("samples", "--json").stdout)
        self.assertEqual({sample["name"] for sample in listed}, {scene.stem for scene in SCENES.glob("*.gltf")})
        text = run("samples").stdout
        for sample in listed:
            self.assertIn(f"{sample['name']:<9} {sample['what']}\n", text)
            path = run("samples", sample["name"])
            self.assertEqual((path.returncode, path.stdout), (0, f"{SCENES.resolve() / sample['name']}.gltf\n"))
            self.assertEqual(path.stdout.strip(), sample["file"])

    def test_an_unknown_sample_is_one_line(self):
        for arguments in (["nobody"], ["--open", "nobody"]):
            result = run("samples", *arguments)
            self.assertEqual((result.returncode, result.stdout), (3, ""))
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
            for word in ("'nobody'", "default", "zoo"):
                self.assertIn(word, result.stderr)
        self.assertEqual(run("samples", "zoo", "--open", "zoo").returncode, 2)

    def test_an_opened_sample_is_what_view_shows(self):
        nowhere = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        opened = run("samples", "--open", "zoo", env=nowhere)
        viewed = run("view", SCENES / "zoo.gltf", env=nowhere)
        self.assertEqual((opened.returncode, opened.stderr), (viewed.returncode, viewed.stderr))
        self.assertEqual(opened.returncode, 3)  # there is no display

    def doctor_without(self, names, source=None):
        """Runs doctor without a display where the dynamic loader finds other files under these names of libraries."""
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        with tempfile.TemporaryDirectory() as folder:
            environment["LD_LIBRARY_PATH"] = folder
            for name in names:
                if source:
                    subprocess.run(["cc", "-shared", "-fPIC", "-o", Path(folder, name), "-x", "c", "-"], input=source, text=True, check=True)
                else:
                    Path(folder, name).write_text("no library")
            result = run("doctor", "--json", env=environment)
        report = json.loads(result.stdout)
        return result, report, {backend["name"]: backend for backend in report["backends"]}

    def test_doctor_renders_a_picture_with_a_closed_form(self):
        result, report, backends = self.doctor_without([])
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(list(backends), ["egl", "osmesa", "window"])
        self.assertEqual(report["can_render"], any(b["works"] for b in backends.values()))
        for backend in backends.values():
            if not backend["works"]:
                self.assertNotIn("\n", backend["failure"])
                continue
            picture = backend["picture"]
            x, z = (2 * (p + 0.5) / 32 - 1 for p in picture["pixel"])
            closed_form = 0.5 / math.pi * 2 / (x * x + z * z + 1) ** 1.5  # ρ/π · I h/d³, h = 1 m
            self.assertAlmostEqual(picture["expected [cd/m^2]"], closed_form, 7)
            self.assertAlmostEqual(picture["measured [cd/m^2]"] / closed_form, 1, 5)
            self.assertLess(picture["max_relative_error"], 1e-5)
        self.assertIn("DISPLAY", backends["window"]["failure"])
        for trial in ("exr", "hdr"):
            self.assertTrue(report[trial]["works"], report[trial])
        self.assertIn("Embree", report["libraries"])
        for program in report["optional_programs"]:
            self.assertEqual(bool(shutil.which(Path(program.get("file", "no such file")).name)), program["found"], program)

    def test_doctor_says_what_a_machine_without_drivers_lacks(self):
        osmesa = ["libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"]
        result, report, backends = self.doctor_without(["libEGL.so.1", "libEGL.so", *osmesa])
        self.assertEqual((result.returncode, report["can_render"]), (3, False))
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn("apt-get install libegl1", result.stderr)
        self.assertIn("libEGL.so.1 is not installed: sudo apt-get install", backends["egl"]["failure"])
        self.assertIn("libosmesa6", backends["osmesa"]["failure"])

    def test_doctor_renders_by_the_backend_that_is_left(self):
        libraries = {"egl": ["libEGL.so.1", "libEGL.so"], "osmesa": ["libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"]}
        for missing, left in (("egl", "osmesa"), ("osmesa", "egl")):
            result, report, backends = self.doctor_without(libraries[missing])
            self.assertFalse(backends[missing]["works"])
            self.assertIn("apt-get install", backends[missing]["failure"])
            self.assertIn("DISPLAY", backends["window"]["failure"])
            self.assertEqual((report["can_render"], result.returncode), (backends[left]["works"], 0 if backends[left]["works"] else 3))

    @unittest.skipUnless(shutil.which("cc"), "needs a C compiler")
    def test_doctor_survives_a_driver_that_crashes(self):
        # Not SIGSEGV: AddressSanitizer makes an exit status of that.
        crash = "#include <stdlib.h>\n__attribute__((constructor)) static void crash(void) { abort(); }\n"
        result, report, backends = self.doctor_without(["libEGL.so.1"], crash)
        self.assertIn("crashed", backends["egl"]["failure"])
        self.assertEqual(result.returncode, 0 if backends["osmesa"]["works"] else 3)

    def commands(self, *path):
        """Yields the words of each command that --help lists, and its help."""
        text = run(*path, "--help").stdout
        yield path, text
        listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.MULTILINE)
        for line in listed.group(1).splitlines() if listed else ():
            if line[2] != " ":
                yield from self.commands(*path, line.split()[0])

    def test_the_manual_has_every_command_and_option_of_help(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(run("manual", "man", folder).returncode, 0)
            pages = {page.name: page.read_text() for page in Path(folder).iterdir()}
        html = run("manual", "html").stdout
        commands = list(self.commands())
        self.assertGreater(len(commands), 25)
        self.assertEqual(set(pages), {"-".join(["steradian", *path]) + ".1" for path, _ in commands})
        for path, text in commands:
            name = "-".join(["steradian", *path])
            page = pages[name + ".1"].replace("\\-", "-")
            section = re.search(rf'<section id="{name}">.*?</section>', html, re.DOTALL).group()
            for option in re.findall(r"^  (-\S+)", text, re.MULTILINE):
                self.assertRegex(page, rf"(?m)^\.TP\n\\fB{re.escape(option)}", name)
                self.assertIn(f"<dt>{option}", section)
        hour = re.search(r'<section id="first-hour">.*?</section>', html, re.DOTALL).group()
        examples = (SCENES.parents[1] / "examples" / "README.md").read_text()
        self.assertEqual(re.findall(r"<h3>(.*)</h3>", hour), re.findall(r"(?m)^## (.*)", examples))
        self.assertEqual(hour.count("<pre>"), len(re.findall(r"(?m)^```\w", examples)))
        self.assertIn("steradian golden approve suite.json cornell", hour)
        for link in re.findall(r'href="#([^"]*)"', html):
            self.assertIn(f'<section id="{link}">', html)

    def test_man_pages_are_roff_without_warnings(self):
        with tempfile.TemporaryDirectory() as folder:
            run("manual", "man", folder)
            for page in sorted(Path(folder).iterdir()):
                text = page.read_text()
                self.assertRegex(text, r"\A\.TH \S+ 1 .*\n\.SH NAME\n\S+ \\- .+\n\.SH SYNOPSIS\n")
                for line in text.splitlines():
                    if line.startswith((".", "'")):
                        self.assertRegex(line, r"^\.(TH|SH|PP|TP|nf|fi)\b", page.name)
            if not shutil.which("man") or not shutil.which("groff"):
                return
            for page in ("steradian.1", "steradian-render.1"):
                shown = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", Path(folder, page)], capture_output=True, text=True,
                                       env={**os.environ, "MANWIDTH": "100", "LC_ALL": "C.UTF-8"}, timeout=100)
                self.assertEqual((shown.returncode, shown.stderr), (0, ""))
            self.assertIn("--tone-curve", shown.stdout)

    def test_completion_is_a_script_of_its_shell(self):
        for shell, check in ("bash", ["bash", "-n"]), ("zsh", ["zsh", "-n"]), ("fish", ["fish", "--no-execute"]):
            script = run("completion", shell).stdout
            for word in ("render", "approve", "tone-curve", "luminance"):
                self.assertIn(word, script, shell)
            self.assertNotIn("compile-trial", script)
            if shutil.which(shell):
                with tempfile.NamedTemporaryFile("w") as file:
                    file.write(script)
                    file.flush()
                    checked = subprocess.run([*check, file.name], capture_output=True, text=True, timeout=100)
                self.assertEqual((checked.returncode, checked.stderr), (0, ""), shell)

    @unittest.skipUnless(shutil.which("fish"), "needs fish")
    def test_fish_completes_commands_options_and_values(self):
        def completed(line):
            result = subprocess.run(["fish", "--no-config", "-c", f"steradian completion fish | source; complete -C '{line}'"],
                                    capture_output=True, text=True, timeout=100,
                                    env={**os.environ, "PATH": f"{Path(STERADIAN).parent}:{os.environ['PATH']}"})
            self.assertEqual(result.stderr, "")
            return [line.split("\t")[0] for line in result.stdout.splitlines()]

        self.assertEqual(completed("steradian rend"), ["render"])
        self.assertEqual(completed("steradian golden app"), ["approve"])
        self.assertEqual(completed("steradian render scene.glb --tone-c"), ["--tone-curve"])
        self.assertEqual(completed("steradian render --estimator a"), ["analytic"])
        self.assertIn("render", completed("steradian --help "))  # a flag takes no value
        self.assertIn("--aov", completed("steradian render --strict --ao"))

    @unittest.skipUnless(shutil.which("zsh"), "needs zsh")
    def test_zsh_completes_commands_and_values(self):
        def offered(*words):
            """Returns what the function for zsh's emulation of bash offers; the shell itself leaves out what does not begin alike."""
            line = " ".join(f"'{word}'" for word in words)
            script = ("autoload -U +X compinit && compinit -u -D; source =(steradian completion zsh); setopt ksharrays; "
                      f"COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _steradian_words; print -l -- ${{COMPREPLY[@]}}")
            result = subprocess.run(["zsh", "-f", "-c", script], capture_output=True, text=True, timeout=100,
                                    env={**os.environ, "PATH": f"{Path(STERADIAN).parent}:{os.environ['PATH']}"})
            self.assertEqual(result.stderr, "")
            return result.stdout.split()

        self.assertIn("approve", offered("steradian", "golden", ""))
        self.assertNotIn("approve", offered("steradian", ""))
        self.assertEqual(offered("steradian", "render", "--estimator", ""), ["sampled", "analytic"])

    def test_the_first_hour_runs(self):
        readme = SCENES.resolve().parents[1] / "examples" / "README.md"
        blocks = re.findall(r"^```(\w+)\n(.*?)^```$", readme.read_text(), re.DOTALL | re.MULTILINE)
        files = {"json": "suite.json", "glsl": "my_shaders/brdf/f_r.glsl"}  # as the text names them
        script = "set -e\n"
        for kind, text in blocks:
            # A window stays until somebody closes it.
            script += re.sub(r"(?m)^steradian view .*$", "true", text) if kind == "sh" else \
                f"mkdir -p {Path(files[kind]).parent}\ncat >{files[kind]} <<'END'\n{text}END\n"
        with tempfile.TemporaryDirectory() as folder:
            ran = subprocess.run(["bash", "-x", "-c", script], cwd=folder, capture_output=True, text=True, timeout=280,
                                 env={**os.environ, "PATH": f"{Path(STERADIAN).parent}:{os.environ['PATH']}"})
            self.assertEqual(ran.returncode, 0, ran.stderr + ran.stdout)
            for file in ("cornell.png", "sure.exr", "golden-results/report.html", "my-a2/README.html", "lobe.svg", "mine.exr"):
                self.assertTrue(Path(folder, file).is_file(), file)


def main():
    global STERADIAN, SCENES
    STERADIAN, SCENES, name = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
    suite = unittest.TestSuite([FirstContact(f"test_{name}")])
    return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
