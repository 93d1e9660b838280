"""`python -m steradian WORDS` and the command `steradian` of a wheel: the program."""
import os
import sys

from ._program import program


def main() -> None:
    file = str(program())
    os.execv(file, [file, *sys.argv[1:]])


if __name__ == "__main__":
    main()
