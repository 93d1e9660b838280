"""The one kind of error that a person sees as a line."""


class Failure(Exception):
    """`what: what to do`; exit status 3."""
