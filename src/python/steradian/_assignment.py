"""Assignments: a student's folder and its marks."""
from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

from . import _native
from ._program import told_in_python


class Marks:
    """The marks of a submission."""

    def __init__(self, result: dict[str, Any], page: str) -> None:
        #: As assets/assignment_result.schema.json describes it.
        self.result = result
        self._page = page

    @property
    def points(self) -> float:
        """The points of all tasks."""
        return float(self.result["points"])

    @property
    def of(self) -> float:
        """The points that could be had, without extra ones."""
        return float(self.result["of"])

    @property
    def tasks(self) -> list[dict[str, Any]]:
        """A dict for each task: id, points, of, status, checks."""
        tasks: list[dict[str, Any]] = self.result["tasks"]
        return tasks

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes the report, one .html file that needs nothing from outside."""
        Path(file).write_text(self._page, encoding="utf-8")

    def __repr__(self) -> str:
        return f"<Marks {self.points:g} of {self.of:g}>"


class Assignment:
    """A student's folder, or the archive of one that was handed in."""

    def __init__(self, submission: str | os.PathLike[str]) -> None:
        self.submission = Path(submission)

    def check(self, *, time_limit: float = 20.0, graded_as: str = "", hidden: str | os.PathLike[str] = "",
              student: str = "") -> Marks:
        """Marks it in processes of their own, as `steradian assignment check` does: a shader that hangs costs its own task.

        time_limit: of one task [s]. graded_as: the name of the assignment, for teachers: the processes are confined, and the
        folder's own label does not count. hidden: a folder of hidden checks. Ctrl-C ends the check.
        """
        with told_in_python():
            text, page = _native.check_assignment(str(self.submission), time_limit, graded_as, os.fspath(hidden), student)
        return Marks(json.loads(text), page)

    def __repr__(self) -> str:
        return f"<Assignment {self.submission}>"
