"""Results as xarray objects, and their files."""

from __future__ import annotations

import json
import sys
import warnings
from collections.abc import Iterable, Mapping
from os import PathLike
from types import FrameType
from typing import Any

import numpy as np
import xarray as xr

__all__ = ["Concern", "answers", "open_results", "to_netcdf"]


class Concern(UserWarning):
    """What a result may be doubted for: a maximum at the end of the range, a missed accuracy, waves that wrap around.

    Attributes
    ----------
    code : str
        Short stable name, such as ``wrap-around``.
    message : str
        What was found, with the number and the limit.
    remedy : str
        What to do about it.

    Examples
    --------
    >>> str(Concern("wrap-around", "2 % of the peak comes back", "widen the clearance"))
    'wrap-around: 2 % of the peak comes back (widen the clearance)'
    """

    def __init__(self, code: str, message: str, remedy: str) -> None:
        super().__init__(code, message, remedy)
        self.code, self.message, self.remedy = code, message, remedy

    def __str__(self) -> str:
        return f"{self.code}: {self.message} ({self.remedy})"


def warn(concerns: Iterable[tuple[str, str, str]]) -> None:
    """Warns of every concern, at the line of the user's that asked."""
    level = 1
    frame: FrameType | None = sys._getframe()
    while frame is not None and frame.f_globals.get("__name__", "").startswith(__package__):
        level, frame = level + 1, frame.f_back
    for concern in concerns:
        warnings.warn(Concern(*concern), stacklevel=level)


def joined(data: xr.Dataset) -> xr.Dataset:
    """Pairs ``…_re``, ``…_im`` as complex arrays."""
    for name in [str(name) for name in data.data_vars if str(name).endswith("_re")]:
        stem = name.removesuffix("_re")
        if f"{stem}_im" in data:
            real, imaginary = data[name], data[f"{stem}_im"]
            attrs = {**real.attrs, "long_name": real.attrs.get("long_name", stem).removesuffix(", real part")}
            values = np.empty(real.shape, dtype=complex)
            values.real, values.imag = real.values, imaginary.values
            data = data.drop_vars([name, f"{stem}_im"]).assign({stem: (real.dims, values, attrs)})
    return data


def parted(data: xr.Dataset) -> xr.Dataset:
    """Complex arrays as pairs ``…_re``, ``…_im``, as files have them."""
    for name in [str(name) for name in data.data_vars if np.iscomplexobj(data[name].values)]:
        whole = data[name]
        text = whole.attrs.get("long_name", name)
        data = data.drop_vars(name).assign({
            f"{name}_{part}": (whole.dims, values, {**whole.attrs, "long_name": f"{text}, {words} part"})
            for part, values, words in [("re", whole.values.real, "real"), ("im", whole.values.imag, "imaginary")]
        })
    return data


def dataset(group: Mapping[str, Any]) -> xr.Dataset:
    """The group of one study."""
    variables = {
        v["name"]: (v["dims"], v["values"], {"units": v["units"], "long_name": v["long_name"]})
        for v in group["variables"]
    }
    coordinates = {name for name, (dims, _, _) in variables.items() if dims == [name]}
    data = xr.Dataset(
        {name: v for name, v in variables.items() if name not in coordinates},
        coords={name: variables[name] for name in coordinates},
        attrs={**group["attributes"], **{f"answer_{a['key']}": a["value"] for a in group["answers"]}},
    )
    told = {a["key"]: {"what": a["what"], "unit": a["unit"], "shown": a["shown"]} for a in group["answers"]}
    return joined(data).assign_attrs(answers=json.dumps(told, ensure_ascii=False))


def answers(data: xr.Dataset | xr.DataTree) -> dict[str, float]:
    """The numbers a reader came for, by the keys they have in ``summary.json``.

    Parameters
    ----------
    data : xarray.Dataset or xarray.DataTree
        What a study answered; its node of the tree of a case.

    Returns
    -------
    dict
        SI values. What each is in words, and its unit, stand in ``json.loads(data.attrs["answers"])``.

    Examples
    --------
    >>> import groundwave as gw
    >>> curve = gw.critical_speed(soil="lamprea2022_half_space", track="lamprea2022_slab",
    ...                           train="lamprea2022_axle", speeds=[90, 105, 120, 135])
    >>> round(gw.answers(curve)["critical_speed"])
    115
    """
    stem = "answer_"
    return {str(key)[len(stem) :]: value for key, value in data.attrs.items() if str(key).startswith(stem)}


def to_netcdf(data: xr.Dataset | xr.DataTree, path: str | PathLike[str]) -> None:
    """Writes results to a NetCDF file: complex arrays as pairs ``…_re``, ``…_im``, which every program reads.

    Needs ``h5netcdf`` (``pip install groundwave[netcdf]``); `open_results` reads it back.

    Parameters
    ----------
    data : xarray.Dataset or xarray.DataTree
        What a study or a case answered.
    path : path-like
        The file, replaced if it exists.

    Examples
    --------
    >>> import groundwave as gw, pathlib, tempfile
    >>> table = gw.surface_compliance(soil="lamprea2022_layered", k=[0.1, 1.0], frequencies=[10.0])
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     gw.to_netcdf(table, pathlib.Path(folder) / "g.nc")
    ...     gw.open_results(pathlib.Path(folder) / "g.nc").identical(table)
    True
    """
    if isinstance(data, xr.DataTree):
        data.map_over_datasets(parted).to_netcdf(path, engine="h5netcdf")
    else:
        parted(data).to_netcdf(path, engine="h5netcdf")


def open_results(path: str | PathLike[str]) -> xr.Dataset | xr.DataTree:
    """Reads what `to_netcdf` or the command ``groundwave run`` has written, complex arrays whole.

    Needs ``h5netcdf`` (``pip install groundwave[netcdf]``).

    Parameters
    ----------
    path : path-like
        A NetCDF file, or the ``results.h5`` of a run.

    Returns
    -------
    xarray.DataTree or xarray.Dataset
        A tree with a node for each study; the data of a single study.

    Examples
    --------
    >>> import groundwave as gw, pathlib, tempfile
    >>> tree = gw.Case({"soil": "lamprea2022_half_space",
    ...                 "surface_compliance": {"k": [0.5], "frequencies": [10.0]}}).run()
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     gw.to_netcdf(tree, pathlib.Path(folder) / "g.nc")
    ...     sorted(gw.open_results(pathlib.Path(folder) / "g.nc").children)
    ['surface_compliance']
    """
    with xr.open_datatree(path, engine="h5netcdf") as tree:
        whole = tree.load().map_over_datasets(joined)
    return whole if whole.children else whole.to_dataset()
