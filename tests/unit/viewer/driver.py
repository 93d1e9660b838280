"""Drives the viewer as a person would: a display of its own, real key and mouse events, a look at the screen."""
import importlib.util
import os
import shutil
import struct
import subprocess
import sys
import time
from pathlib import Path

# How long anything is waited for [s]: long enough for a machine under load. What hangs is ended.
PATIENCE = 240.0


def skip_without(*programs: str, modules: tuple[str, ...] = ()):
    """Ends a test as skipped, with status 77, where a program or a Python module that it needs is missing."""
    missing = [name for name in ("Xvfb", "xdotool", *programs) if not shutil.which(name)]
    missing += [name for name in modules if not importlib.util.find_spec(name)]
    if missing:
        print(f"SKIPPED: {', '.join(missing)} missing: tools/setup")
        sys.exit(77)


class Display:
    """Xvfb, whose framebuffer is a file in the form of xwd, so that nothing else is needed to look at it. Keys do not repeat (-r): a machine
    under load may hold one for a second."""

    def __init__(self, folder: Path, width: int, height: int, dots_per_inch: int = 96):
        folder.mkdir(parents=True, exist_ok=True)
        self.file = folder / "Xvfb_screen0"
        read, write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-fbdir", str(folder),
             "-dpi", str(dots_per_inch), "-nolisten", "tcp", "-noreset", "-r"], pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start")
        self.environment = {**os.environ, "DISPLAY": f":{number}", "XDG_CONFIG_HOME": str(folder / "config"),
                            "XDG_STATE_HOME": str(folder / "state"), "XDG_CACHE_HOME": str(folder / "cache"),
                            # The driver's compiled shaders stay where other runs find them.
                            "MESA_SHADER_CACHE_DIR": os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")}
        self.environment.pop("WAYLAND_DISPLAY", None)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def do(self, *arguments) -> str:
        """xdotool, which makes real events (XTEST)."""
        result = subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, capture_output=True,
                                text=True, timeout=PATIENCE)
        return result.stdout.strip()

    def words(self):
        """All pixels of the screen, row by row, each 0x00rrggbb."""
        data = self.file.read_bytes()
        header = struct.unpack(">25I", data[:100])
        start = header[0] + 12 * header[19]
        return memoryview(data)[start:start + header[12] * header[5]].cast("I")

    def size(self) -> tuple[int, int]:
        """Width and height [pixels]."""
        header = struct.unpack(">25I", self.file.read_bytes()[:100])
        return header[4], header[5]

    def pixels(self):
        """The screen: its width and a function from x, y to (r, g, b)."""
        data = self.file.read_bytes()
        header = struct.unpack(">25I", data[:100])
        width, line, colors = header[4], header[12], header[19]
        start = header[0] + 12 * colors

        def pixel(x, y):
            first = start + y * line + 4 * x
            b, g, r = data[first:first + 3]
            return r, g, b
        return pixel

    def close(self):
        self.process.terminate()
        self.process.wait()


class Viewer:
    """A running `steradian view`, in the working directory `folder`, where its screenshots go. It begins with all panels, unless it
    remembers those of the run before."""

    def __init__(self, display: Display, steradian: str, folder: Path, *arguments, remembers: bool = False):
        self.display, self.folder = display, folder
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        if not remembers:
            (Path(display.environment["XDG_CONFIG_HOME"]) / "steradian/panels").unlink(missing_ok=True)
        self.fields = 0  # that were typed into
        self.log = open(folder / "stderr", "w+")
        self.process = subprocess.Popen([steradian, "view", "--verbose", *map(str, arguments)], cwd=folder,
                                        env=display.environment, stdout=subprocess.PIPE, stderr=self.log, text=True)
        self.window = self.wait(lambda: display.do("search", "--onlyvisible", "--name", "Steradian"), "a window")
        self.window = self.window.splitlines()[0]
        display.do("windowfocus", self.window)

    def wait(self, condition, what: str, seconds: float = PATIENCE, interval: float = 0.03):
        """Until the condition holds, which is looked at once an interval [s]; its value."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            value = condition()
            if value:
                return value
            if self.process.poll() is not None:
                raise AssertionError(f"the viewer ended with {self.process.returncode}: {self.errors()}")
            time.sleep(interval)
        raise AssertionError(f"waited {seconds} s for {what}; title: {self.title()}; {self.errors()}")

    def said(self, text: str, count: int = 1, seconds: float = PATIENCE):
        """Until it has said this text so many times."""
        self.wait(lambda: self.errors().count(text) >= count, text, seconds)

    def title(self) -> str:
        return self.display.do("getwindowname", self.window)

    def errors(self) -> str:
        self.log.flush()
        return Path(self.log.name).read_text()

    def converged(self) -> int:
        """How many pictures have converged so far."""
        return self.errors().count("converged: ")

    def done(self):
        """Until the first picture has converged."""
        self.wait(self.converged, "a converged picture")

    def key(self, *keys):
        self.display.do("key", "--delay", "30", *keys)

    def changed_by(self, act):
        """Does something that changes the picture, and waits until it has converged again."""
        before = self.converged()
        act()
        self.wait(lambda: self.converged() > before, "a picture that converged again")

    def move(self, x, y):
        self.display.do("mousemove", x, y)

    def resize(self, width: int, height: int):
        """The window, at the upper left of the screen."""
        self.display.do("windowmove", self.window, 0, 0, "windowsize", self.window, width, height)

    def drag(self, begin, end, button=1):
        """All in one go: a pause would let a picture converge in between."""
        moves = [part for i in range(1, 5)
                 for part in ("mousemove", *(round(a + (b - a) * i / 4) for a, b in zip(begin, end)))]
        self.display.do("mousemove", *begin, "mousedown", button, *moves, "mouseup", button)

    def pull(self, begin, end):
        """Drags a part of a panel, which sees the pointer once a frame."""
        for action in ("mousemove", *begin), ("mousedown", 1), ("mousemove", *end), ("mouseup", 1):
            self.display.do(*action)
            self.pause()

    def click(self, x, y):
        self.display.do("mousemove", x, y, "click", "1")

    def type(self, text: str):
        """Into the field that has the keyboard, and Enter."""
        self.fields += 1
        self.wait(lambda: self.errors().count("text field focused") >= self.fields, "a field to type into")
        self.display.do("type", "--delay", "20", text)
        self.key("Return")

    def fill(self, key: str, form: str, fields: dict[str, str | None]):
        """Opens a form by a key, types into its fields one after the other (None: leaves what is there), and presses Enter."""
        for name, text in fields.items():
            said = f"Field of the {form}: {name}\n"
            count = self.errors().count(said)
            self.key(key)
            self.said(said, count + 1)
            if text is not None:
                self.display.do("type", "--delay", "20", text)
            key = "Tab"
        self.key("Return")

    def count(self, color: tuple[int, int, int]) -> int:
        """How many pixels of the screen have just this colour now."""
        pixels = self.display.words()
        return sum(word & 0xffffff == (color[0] << 16 | color[1] << 8 | color[2]) for word in pixels)

    @staticmethod
    def pause():
        """Gives the window time to draw, before a check that something has not changed. What shall change is waited for."""
        time.sleep(0.3)

    @staticmethod
    def write(file: Path, text: str):
        """Saves a file as editors do: whole."""
        unfinished = file.with_suffix(".new")
        unfinished.write_text(text)
        unfinished.rename(file)

    def screen(self, x: int, y: int) -> tuple[int, int, int]:
        """A pixel of the screen as it is now."""
        return self.display.pixels()(x, y)

    def shot(self, exr: bool = True) -> Path:
        """A screenshot by the viewer's own key."""
        suffix = ".exr" if exr else ".png"
        before = set(self.folder.glob("*" + suffix))
        self.key("shift+F12" if exr else "F12")
        new = self.wait(lambda: set(self.folder.glob("*" + suffix)) - before, "a screenshot")
        return new.pop()

    def processor_time(self) -> float:
        """Of all threads so far [s]."""
        fields = Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def close(self) -> str:
        """Quits by its key; what it printed."""
        self.key("ctrl+q")
        output, _ = self.process.communicate(timeout=PATIENCE)
        assert self.process.returncode == 0, (self.process.returncode, self.errors())
        return output
