"""Exceptions and warnings of the module."""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Sequence
from typing import NamedTuple


class Diagnostic(NamedTuple):
    """One thing that is wrong with an input.

    Attributes
    ----------
    file : str
        The file, or the name of the argument or setting.
    position : str
        Where in it: 'line 7', 'materials.3.emissivity'; '' for the whole.
    value : str
        What was found.
    expected : str
        What would have been right.
    """

    file: str
    position: str
    value: str
    expected: str

    def __str__(self) -> str:
        place = ": ".join(part for part in (self.file, self.position) if part)
        words = ", ".join(
            word + part
            for word, part in (("found ", self.value), ("expected ", self.expected))
            if part
        )
        return ": ".join(part for part in (place, words) if part)


class InputError(ValueError):
    """A file or a value cannot be used.

    Attributes
    ----------
    diagnostics : tuple of Diagnostic
        Everything that is wrong, at least one.
    file, position, value, expected : str
        Those of the first diagnostic.
    """

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        super().__init__(tuple(diagnostics))
        self.diagnostics = tuple(diagnostics)
        self.file, self.position, self.value, self.expected = self.diagnostics[0]

    def __str__(self) -> str:
        return "\n".join(str(diagnostic) for diagnostic in self.diagnostics)


class LogicError(RuntimeError):
    """The module is used in a way that it is not made for, or is wrong itself."""


class SmatWarning(UserWarning):
    """What a reader took for granted, and what results warn of."""


def warn_of(sentences: Sequence[str]) -> None:
    """Warn of each sentence as of the line that called the module."""
    package = os.path.dirname(__file__)
    level, frame = 1, sys._getframe(0)
    while frame.f_back is not None and frame.f_code.co_filename.startswith(package):
        level, frame = level + 1, frame.f_back
    for sentence in sentences:
        warnings.warn(sentence, SmatWarning, stacklevel=level)
