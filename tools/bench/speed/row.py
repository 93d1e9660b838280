"""A row of the table of speed, as the functions that measure rows return it."""
from dataclasses import dataclass, field
from pathlib import Path

from peers import install
from timing import Progress, Spread, spread


class Skipped(Exception):
    """A row that cannot be measured here, with the reason."""


@dataclass
class Line:
    what: str
    ours: str
    beside: str                  # the peer's figure, or –
    aim: str
    is_met: bool | None          # none: the line has no aim, or its peer is missing
    ratio: Spread | None = None  # ours over theirs, turn by turn
    remark: str = ""

    def cells(self) -> str:
        met = {True: "met", False: "**not met**", None: ""}[self.is_met]
        return f"| {self.what} | {self.ours} | {self.beside} | {self.ratio.text() if self.ratio else '–'} | {self.aim} | {met} | {self.remark} |"


@dataclass
class Setting:
    """How the rows are measured."""
    program: Path
    scratch: Path
    progress: Progress
    model: Path | None           # DamagedHelmet.glb
    is_quick: bool
    runs: int
    is_fresh: bool               # render long pictures again
    cache: Path = install.CACHE
    figures: dict = field(default_factory=dict)  # everything that was measured, for --json

    def helmet(self) -> Path:
        """@throws Skipped"""
        if not self.model:
            raise Skipped("needs DamagedHelmet.glb: give its path by --model")
        return self.model

    def folder(self, name: str) -> Path:
        path = self.scratch / name
        path.mkdir(parents=True, exist_ok=True)
        return path


def ratio_of(ours: list, theirs: list) -> Spread:
    """Turn by turn, so that both met the same load. @throws Skipped if a difference of times is not positive"""
    if min(*ours, *theirs) <= 0:
        raise Skipped("more frames took no longer than few: the machine is too busy")
    return spread(a / b for a, b in zip(ours, theirs))
