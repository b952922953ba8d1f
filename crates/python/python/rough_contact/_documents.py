"""What a study leaves: documents by name, written into a folder."""

from __future__ import annotations

import copy
import json
import os
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from . import _rough_contact as _rust

__all__ = ["Documents"]


@dataclass(frozen=True, repr=False)
class Documents:
    """The files of a study.

    Attributes
    ----------
    files : dict
        The documents by their names, ``results.json`` and ``report.html`` among them.
    """

    files: dict[str, str]

    @cached_property
    def json(self) -> dict[str, Any]:
        """The object of ``results.json``."""
        found: dict[str, Any] = json.loads(self.files["results.json"])
        return found

    @property
    def html(self) -> str:
        """The report: one page that needs nothing else."""
        return self.files["report.html"]

    def to_dict(self) -> dict[str, Any]:
        """The object of ``results.json``."""
        return copy.deepcopy(self.json)

    def write(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Writes the documents into a folder, which is made.

        Raises
        ------
        FileExistsError
            If one of the files exists, unless `overwrite`; nothing is written then.
        """
        os.makedirs(folder, exist_ok=True)
        paths = {os.path.join(folder, name): text for name, text in self.files.items()}
        for path in paths:
            if os.path.lexists(path) and not overwrite:
                raise FileExistsError(f"{path} exists; give overwrite=True or another folder")
        for path, text in paths.items():
            if os.path.basename(path) == "run.toml":
                text = _rust.run_file_in(text, os.fspath(folder))
            with open(path, "w", encoding="utf-8", newline="") as file:
                file.write(text)
