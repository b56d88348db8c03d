"""Cases: read, checked, run."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from os import PathLike
from typing import Any

import xarray as xr

from . import _core
from .results import dataset, warn

__all__ = ["Case"]

#: Called now and then with what is being done, how many of its steps are done, and how many there are.
Progress = Callable[[str, int, int], object]


class Case:
    """A case ready to run: ground, track, train and questions, everything checked.

    Parameters
    ----------
    source : path-like, str or mapping
        Path of a case file or of a ``results.h5``; the text of a case file (more than one line); or its tables as a dictionary, in
        which arrays, slices (``slice(10, 200, 2)`` for ``{from, to, step}``), `Soil`, `Track`, `Train` and `Springs` may stand.
        Numbers are SI, or texts with a unit such as ``"250 km/h"``.
    folder : path-like, optional
        Where files beside the case are looked for; that of the case file, or the working folder.
    files : mapping, optional
        Contents of files beside the case, by the name the case uses.

    Raises
    ------
    CaseError
        Everything wrong with it, each fault with key, line, what was found and what is allowed.

    Examples
    --------
    >>> case = Case({"title": "Compliance", "soil": "lamprea2022_layered",
    ...              "surface_compliance": {"k": [0.1, 1.0], "frequencies": slice(5, 20, 5)}})
    >>> case.studies
    ['surface_compliance']
    >>> case.run()["surface_compliance"].u_zz.shape
    (4, 2)
    """

    def __init__(
        self,
        source: str | PathLike[str] | Mapping[str, Any],
        *,
        folder: str | PathLike[str] | None = None,
        files: Mapping[str, str] | None = None,
    ) -> None:
        if isinstance(source, Mapping):
            text, name = _core.toml({"title": "Case", **source}), "case"
        elif isinstance(source, str) and "\n" in source:
            text, name = source, "case"
        elif folder is None and files is None:
            self._name, self._core = os.fspath(source), _core.Case.load(os.fspath(source))
            return
        else:
            name = os.fspath(source)
            with open(name, encoding="utf-8") as file:
                text = file.read()
            folder = os.path.dirname(name) if folder is None else folder
        self._name = name
        self._core = _core.Case.parse(text, name, os.fspath(folder or "."), dict(files or {}))

    @property
    def title(self) -> str:
        """Title of the case."""
        return self._core.title

    @property
    def text(self) -> str:
        """The case file, as the command ``groundwave`` reads it."""
        return self._core.text

    @property
    def files(self) -> dict[str, str]:
        """Contents of every other file the case uses, library entries included, by the name it uses."""
        return self._core.files

    @property
    def studies(self) -> list[str]:
        """Names of its studies."""
        return self._core.studies

    def estimate(self) -> dict[str, float]:
        """About how long each study takes on the threads there are [s], without pictures and files.

        Every study is tried for a second at most; with a second solver or method twice.

        Raises
        ------
        ComputationError
            A study that has no answer.

        Examples
        --------
        >>> case = Case({"soil": "lamprea2022_half_space",
        ...              "dispersion": {"frequencies": [10.0, 20.0], "modes": 1}})
        >>> case.estimate()["dispersion"] < 60.0
        True
        """
        return self._core.estimate()

    def run(
        self,
        progress: Progress | None = None,
        *,
        out: str | PathLike[str] | None = None,
        overwrite: bool = False,
    ) -> xr.DataTree:
        """Computes every study.

        Ctrl-C ends it within a second. Other Python threads go on meanwhile.

        Parameters
        ----------
        progress : callable, optional
            Called as ``progress(what, done, steps)``; what it raises ends the run.
        out : path-like, optional
            A folder in which to leave what the command ``groundwave run`` does: report, pictures, ``results.h5``, tables. It appears
            whole or not at all.
        overwrite : bool
            Replaces that folder, if it holds nothing but results of this program.

        Returns
        -------
        xarray.DataTree
            A node for each study, with units, coordinates and answers (see `answers`); attributes as those of ``results.h5``.

        Raises
        ------
        ComputationError
            A study that has no answer.
        OSError
            A folder that exists, or cannot be made.

        Warns
        -----
        Concern
            What the results may be doubted for; also in the attribute ``concerns``.

        Examples
        --------
        >>> case = Case({"soil": "lamprea2022_half_space",
        ...              "dispersion": {"frequencies": [10.0, 20.0], "modes": 1}})
        >>> case.run()["dispersion"].phase_velocity.units
        'm s-1'
        """
        found = self._core.run(progress, None if out is None else os.fspath(out), overwrite)
        warn(found["concerns"])
        nodes = {group["name"]: dataset(group) for group in found["groups"]}
        return xr.DataTree.from_dict({"/": xr.Dataset(attrs=found["attributes"]), **nodes})

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self.text, self._name, self.files)

    def __repr__(self) -> str:
        return f"Case({self.title!r}, studies={self.studies})"


def _restored(text: str, name: str, files: dict[str, str]) -> Case:
    case = object.__new__(Case)
    case._name, case._core = name, _core.Case.parse(text, name, ".", files)
    return case
