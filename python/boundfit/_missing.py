"""The exception about a file that is not there."""

from __future__ import annotations

import errno
from typing import Any


class MissingFile(FileNotFoundError, ValueError):
    """A file that is not there: a ``FileNotFoundError``, and the ``ValueError`` that refuses everything else, too."""

    def __init__(self, message: str, filename: str) -> None:
        super().__init__(message)
        self.errno, self.filename = errno.ENOENT, filename

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> Any:
        return MissingFile, (self.args[0], self.filename)
