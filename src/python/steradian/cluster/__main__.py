"""Runs as `python -m steradian.cluster`, and as `python FOLDER` where no package is installed."""
import sys
from pathlib import Path

if not __package__:
    sys.path[0] = str(Path(__file__).resolve().parent.parent)
    __package__ = "cluster"
    import cluster  # type: ignore[import-not-found]  # noqa: F401

from .command import main  # noqa: E402

sys.exit(main())
