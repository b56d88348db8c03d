"""The library of named soils, tracks and vehicles."""

from __future__ import annotations

from . import _core

__all__ = ["library", "show"]


def library(kind: str | None = None) -> dict[str, str]:
    """Names that may stand for a `Soil`, a `Track` or a `Train`, with their titles.

    Parameters
    ----------
    kind : {"soils", "tracks", "vehicles"}, optional
        Which of them; all by default.

    Examples
    --------
    >>> library("soils")["lamprea2022_layered"]
    '2 m of soft soil over a stiffer half-space'
    """
    return {name: title for shelf, name, title, _ in _core.library() if kind in (None, shelf)}


def show(name: str) -> str:
    """What an entry of the library holds, where it comes from and what follows from it, in lines.

    Parameters
    ----------
    name : str
        One of `library`.

    Examples
    --------
    >>> "c_s 124.2 m/s" in show("lamprea2022_half_space")
    True
    """
    return _core.show(name)
