"""The command line of python -m steradian.cluster."""
import argparse
import os
import re
import shutil
import signal
import sys
from pathlib import Path
from typing import Callable

from .failure import Failure
from .frames import render
from .goldens import golden
from .grading import grade

EXAMPLES = """
Start a scheduler and workers first, each in an environment with the Python package distributed and the steradian program:
  dask scheduler                                   prints its address, such as tcp://192.0.2.1:8786
  dask worker tcp://192.0.2.1:8786 --nthreads 2    on each machine

Examples:
  python -m steradian.cluster grade a3 --submissions downloads --out marks --scheduler tcp://192.0.2.1:8786
  python -m steradian.cluster render dancer.glb --frames 0:240 -o walk.####.exr --scheduler tcp://192.0.2.1:8786 -- --samples 256
  python -m steradian.cluster render vase.glb --turntable 120 -o vase.###.png --scheduler tcp://192.0.2.1:8786
  python -m steradian.cluster golden suite.json -o golden-results --scheduler tcp://192.0.2.1:8786

Exit status: that of the same command on one machine; 3 if a file, the scheduler or a worker is at fault; 130 after Ctrl-C, whereupon
the same command goes on (render: with --resume).
"""


def frame_range(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d+):(\d+)", text)
    if not found or int(found[1]) > int(found[2]):
        raise argparse.ArgumentTypeError(f"{text}: write FIRST:LAST, such as 0:240")
    return int(found[1]), int(found[2])


def count(text: str) -> int:
    if not text.isdigit() or not 1 <= int(text) <= 1_000_000:
        raise argparse.ArgumentTypeError(f"{text}: write a number from 1 on")
    return int(text)


def parser() -> argparse.ArgumentParser:
    form = argparse.RawDescriptionHelpFormatter
    whole = argparse.ArgumentParser(prog="python -m steradian.cluster", description=__doc__ and "Steradian on the workers of a Dask scheduler.",
                                    epilog=EXAMPLES, formatter_class=form)
    commands = whole.add_subparsers(required=True, metavar="COMMAND")

    def command(name: str, run: Callable[[argparse.Namespace], int], text: str) -> argparse.ArgumentParser:
        one = commands.add_parser(name, help=text, description=text, epilog=EXAMPLES, formatter_class=form)
        one.add_argument("--scheduler", required=True, metavar="ADDRESS", help="of the Dask scheduler, e.g. tcp://host:8786")
        one.add_argument("--program", default="steradian", help="steradian here; workers take the same path, or the one in their PATH")
        one.set_defaults(run=run)
        return one

    grading = command("grade", grade, "mark a class, as `steradian assignment grade` does")
    grading.add_argument("assignment", help="an assignment (a3, a3-brdf) or its folder")
    grading.add_argument("--submissions", required=True, type=Path, metavar="DIR")
    grading.add_argument("--out", required=True, type=Path, metavar="DIR")
    grading.add_argument("--hidden", type=Path, metavar="DIR")
    grading.add_argument("--time-limit", default="20", metavar="SECONDS", help="of one task (default: 20)")
    grading.add_argument("--memory", default="2048", metavar="MIB", help="of one submission (default: 2048)")
    rendering = command("render", render, "render frames or a turntable, as `steradian render --frames` and `--turntable` do")
    rendering.add_argument("scene", type=Path)
    rendering.add_argument("--frames", type=frame_range, metavar="FIRST:LAST", help="of the animation, or some of the turntable's pictures")
    rendering.add_argument("--turntable", type=count, metavar="COUNT", help="pictures from a camera that goes once around the scene")
    rendering.add_argument("-o", "--output", required=True, action="append", type=Path, metavar="OUT", help="with #### in its name (repeatable)")
    rendering.add_argument("--chunk", default=1, type=count, help="frames of one task (default: 1)")
    rendering.add_argument("--resume", action="store_true", help="keep the frames that are there")
    rendering.usage = "%(prog)s SCENE --frames FIRST:LAST|--turntable COUNT -o OUT --scheduler ADDRESS [--chunk N] [--resume] [-- OPTIONS of `steradian render`]"
    suites = command("golden", golden, "run a golden suite, as `steradian golden run` does")
    suites.add_argument("suite", type=Path)
    suites.add_argument("-o", "--output", default=Path("golden-results"), type=Path, metavar="DIR")
    suites.add_argument("--parts", type=count, help="of the suite (default: four for each thread of the workers)")
    suites.add_argument("--retries", default=0, type=int)
    suites.add_argument("--shaders", default=[], action="append", type=Path, metavar="DIR")
    suites.add_argument("--also", default=[], action="append", type=Path, metavar="PATH", help="what commands of the suite need besides (repeatable)")
    return whole


def main() -> int:
    words = sys.argv[1:]
    behind = words.index("--") if "--" in words else len(words)
    arguments = parser().parse_args(words[:behind])
    arguments.options = words[behind + 1:]  # of `steradian render`
    if arguments.options and arguments.run is not render:
        parser().error("options behind -- are for render")
    signal.signal(signal.SIGTERM, lambda *_: (_ for _ in ()).throw(KeyboardInterrupt()))
    try:
        found = shutil.which(arguments.program)
        if not found:
            raise Failure(f"{arguments.program}: no such program: install Steradian, or name it with --program")
        arguments.program = os.path.abspath(found)
        return int(arguments.run(arguments))
    except Failure as failure:
        print(failure, file=sys.stderr)
        return 3
    except OSError as error:
        print(f"{error.filename or 'a file'}: {error.strerror or error}: see that it is there and may be used", file=sys.stderr)
        return 3
    except KeyboardInterrupt:
        print("interrupted: the same command goes on from there", file=sys.stderr)
        return 130
