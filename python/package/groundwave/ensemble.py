"""Samples of an uncertain case, in threads or on a cluster."""

from __future__ import annotations

import os
from os import PathLike
from typing import TYPE_CHECKING

import xarray as xr

from . import _core
from .case import Case, Progress
from .results import dataset, warn

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["study"]


def study(
    case: Case,
    out: str | PathLike[str],
    *,
    client: Client | None = None,
    report: bool = False,
    progress: Progress | None = None,
) -> xr.DataTree:
    """Runs the samples of a case with ``[study]``, and gathers them.

    Samples stand in chunks of 25, each a file of the folder that is whole or not there: whatever ends a run, the same call goes on
    from there, and a study that the command ``groundwave study`` has begun is continued. Numbers depend on the seed, the sample and
    its key alone, not on threads, workers or order.

    Parameters
    ----------
    case : Case
        With a table ``study``: ``samples``, ``seed``, ``method``, ``vary``, ….
    out : path-like
        Folder of this study. Workers of a client write to it: a cluster needs one that all its machines see.
    client : distributed.Client, optional
        A Dask client, whose workers run a chunk each (``pip install groundwave[dask]``); by default the threads of this process. A
        worker that dies costs the chunk it was at, which another one runs.
    report : bool
        Leaves report, pictures, ``study.h5`` and the worst samples in ``out/gathered``, as the command does.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.DataTree
        The node ``study`` with what varies and every answer over ``sample``, and one for every study with its curves over ``sample``;
        what a refused sample lacks is NaN.

    Raises
    ------
    OSError
        A folder that holds something else, or cannot be written to.
    ValueError
        A case without ``[study]``, a folder with another study, chunks that lack.

    Warns
    -----
    Concern
        What the numbers may be doubted for: refused samples above all.

    Examples
    --------
    >>> import groundwave as gw, tempfile
    >>> case = gw.Case({
    ...     "soil": {"half_space": {"young": 50e6, "poisson": 0.4, "density": 1800.0, "loss_factor": 0.06}},
    ...     "dispersion": {"frequencies": [10.0, 20.0], "modes": 1},
    ...     "study": {"samples": 4, "seed": 1, "derivatives": False, "vary": [
    ...         {"key": "soil.half_space.young", "kind": "uniform", "from": 40e6, "to": 60e6}]},
    ... })
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tree = gw.study(case, folder)
    >>> tree["study"].sizes["sample"]
    4
    """
    out = os.fspath(out)
    chunks = case._core.chunks
    if client is None or chunks is None:
        case._core.sample(out, 1, 1, progress)
    else:
        _on(client, case, (os.path.abspath(out), chunks), progress)
    groups = _core.gather(out, report, progress)
    warn(concern for group in groups for concern in group["concerns"])
    return xr.DataTree.from_dict({group["name"]: dataset(group) for group in groups})


def _chunk(case: Case, out: str, number: int, of: int) -> int:
    """Runs one chunk, if it is not there."""
    case._core.sample(out, number, of, None)
    return number


def _on(client: Client, case: Case, place: tuple[str, int], progress: Progress | None) -> None:
    """A task for each chunk; those of workers that die are run again."""
    from distributed import as_completed

    out, chunks = place
    tasks = [client.submit(_chunk, case, out, number + 1, chunks, pure=False) for number in range(chunks)]
    try:
        for done, task in enumerate(as_completed(tasks), 1):
            task.result()
            if progress is not None:
                progress("samples", done, chunks)
    finally:
        client.cancel(tasks)
