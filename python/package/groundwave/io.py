"""Ground from site investigations: cone penetration tests and inverted surface waves as soils.

Cone penetration tests are read by `pygef <https://pypi.org/project/pygef>`_ (GEF, BRO-XML; ``pip install groundwave[gef]``) and
`python-ags4 <https://pypi.org/project/python-ags4>`_ (AGS4; ``groundwave[ags]``). Shear speeds follow by a named correlation, whose scatter
is kept: `vary` hands it to ``[study]``.

Examples
--------
>>> import numpy as np, xarray as xr
>>> from groundwave import io
>>> depth = np.arange(0.5, 8.0, 0.5)
>>> cpt = xr.Dataset({"cone_resistance": ("depth", np.where(depth < 3, 0.6e6, 6e6)),
...                   "sleeve_friction": ("depth", np.where(depth < 3, 20e3, 40e3))}, coords={"depth": depth})
>>> speeds = io.shear_speed(cpt, "robertson2009", water_depth=1.0, unit_weight=18e3)
>>> soil = io.soil(speeds, boundaries=[3.0, 7.5], poisson=0.45, density=1800.0, damping_ratio=0.03,
...                half_space={"shear_speed": 250.0, "poisson": 0.45, "density": 2000.0, "damping_ratio": 0.02})
>>> bool(soil.layers.shear_speed[0] < soil.layers.shear_speed[1])
True
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import Any

import numpy as np
import xarray as xr

from .tables import Soil

__all__ = ["CORRELATIONS", "Correlation", "read_cpt", "read_models", "shear_speed", "soil", "vary"]

#: Atmospheric pressure [Pa].
ATMOSPHERE = 100e3
#: Unit weight of water [N/m³].
WATER = 9.81e3

#: Of AGS4 files, in pascals.
_PASCALS = {"MN/m2": 1e6, "MPa": 1e6, "kN/m2": 1e3, "kPa": 1e3, "N/m2": 1.0, "Pa": 1.0}
_MEANING = {"cone_resistance": "q_c", "sleeve_friction": "f_s", "pore_pressure": "u₂ behind the cone"}


@dataclass(frozen=True)
class Correlation:
    """A way from a cone penetration test to shear speeds.

    Attributes
    ----------
    source : str
        The publication.
    speed : callable
        c_s [m/s] of depth [m], q_t, q_c, f_s [Pa], behaviour index I_c and net resistance q_t − σ_v [Pa].
    scatter : callable
        Standard deviation of ln c_s, of depth [m] and c_s [m/s].

    Examples
    --------
    >>> CORRELATIONS["mayne1995"].source
    'Mayne & Rix (1995), Soils and Foundations 35(2): 107-110; intact and fissured clays; scatter assumed'
    """

    source: str
    speed: Callable[..., np.ndarray]
    scatter: Callable[[np.ndarray, np.ndarray], np.ndarray]


def _assumed(depth: np.ndarray, speed: np.ndarray) -> np.ndarray:
    """Where none is published: 0.2, about what others have found."""
    return np.full_like(speed, 0.2)


def _mcgann_scatter(depth: np.ndarray, speed: np.ndarray) -> np.ndarray:
    """0.162 down to 5 m, 0.216 − 0.0108 z to 10 m, 0.108 below."""
    return np.clip(0.216 - 0.0108 * depth, 0.108, 0.162)


#: Correlations by name.
CORRELATIONS: dict[str, Correlation] = {
    "robertson2009": Correlation(
        "Robertson (2009), Canadian Geotechnical Journal 46: 1337-1355; young uncemented soils; scatter assumed",
        # [10^(0.55 I_c + 1.68) (q_t − σ_v)/p_a]^½
        lambda ic, net, **_: np.sqrt(10 ** (0.55 * ic + 1.68) * net / ATMOSPHERE),
        _assumed,
    ),
    "andrus2007": Correlation(
        "Andrus, Mohanan, Piratheepan, Ellis & Holzer (2007), 4th Int. Conf. Earthquake Geotechnical Engineering, paper 1454; Holocene soils",
        # 2.27 q_t^0.412 I_c^0.989 z^0.033, q_t in kPa
        lambda qt, ic, depth, **_: 2.27 * (qt / 1e3) ** 0.412 * ic**0.989 * depth**0.033,
        # 24 m/s about the estimate
        lambda depth, speed: np.log1p(24.0 / speed),
    ),
    "mcgann2015": Correlation(
        "McGann, Bradley, Taylor, Wotherspoon & Cubrinovski (2015), Soil Dynamics and Earthquake Engineering 75: 66-75; Christchurch",
        # 18.4 q_c^0.144 f_s^0.0832 z^0.278, stresses in kPa
        lambda qc, fs, depth, **_: 18.4 * (qc / 1e3) ** 0.144 * (fs / 1e3) ** 0.0832 * depth**0.278,
        _mcgann_scatter,
    ),
    "mayne1995": Correlation(
        "Mayne & Rix (1995), Soils and Foundations 35(2): 107-110; intact and fissured clays; scatter assumed",
        # 1.75 q_t^0.627, q_t in kPa
        lambda qt, **_: 1.75 * (qt / 1e3) ** 0.627,
        _assumed,
    ),
}


def read_cpt(path: str | PathLike[str], test: str | None = None) -> xr.Dataset:
    """Reads a cone penetration test: GEF or BRO-XML, or AGS4 where the name ends in ``.ags``.

    Parameters
    ----------
    path : path-like
        The file.
    test : str, optional
        Of an AGS4 file with several: which location (``LOCA_ID``).

    Returns
    -------
    xarray.Dataset
        ``cone_resistance``, ``sleeve_friction`` and, where measured, ``pore_pressure`` [Pa] over ``depth`` [m]; attribute
        ``net_area_ratio`` of the cone, where it is known.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> gef = '''#GEFID= 1, 1, 0
    ... #COLUMNINFO= 1, m, sondeerlengte, 1
    ... #COLUMNINFO= 2, MPa, conusweerstand, 2
    ... #COLUMNINFO= 3, MPa, wrijving, 3
    ... #REPORTCODE= GEF-CPT-Report, 1, 1, 2, -
    ... #XYID= 31000, 79578.38, 424838.97, 0.02, 0.02
    ... #ZID= 31000, -0.09, 0.05
    ... #EOH=
    ... 1.0 0.5 0.02
    ... 2.0 0.8 0.03
    ... '''
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder) / "test.gef"
    ...     _ = file.write_text(gef)
    ...     read_cpt(file).cone_resistance.values
    array([500000., 800000.])
    """
    name = os.fspath(path)
    if not os.path.exists(name):
        raise FileNotFoundError(name)
    columns, more = _ags(name, test) if name.lower().endswith(".ags") else _gef(name)
    if "cone_resistance" not in columns or "sleeve_friction" not in columns:
        raise ValueError(f"{name}: cone resistance and sleeve friction are needed, found {', '.join(columns)}")
    depth = columns.pop("depth")
    data = {key: ("depth", values, {"units": "Pa", "long_name": _MEANING[key]}) for key, values in columns.items()}
    units = {"units": "m", "long_name": "depth below the surface"}
    return xr.Dataset(data, coords={"depth": ("depth", depth, units)}, attrs={"source": os.path.basename(name), **more})


def _gef(name: str) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    try:
        from pygef import read_cpt as read
    except ImportError as error:
        raise ImportError("GEF and BRO-XML files need pygef: pip install 'groundwave[gef]'") from error
    test = read(name)
    table = test.data
    # of a GEF file by the number of its quantity; BRO-XML is in MPa
    units = {info[3]: info[1].strip() for info in (test.raw_headers or {}).get("COLUMNINFO", [])}
    columns = {"depth": table["depth" if "depth" in table.columns else "penetrationLength"].cast(float).to_numpy()}
    for key, column, number in [
        ("cone_resistance", "coneResistance", "2"),
        ("sleeve_friction", "localFriction", "3"),
        ("pore_pressure", "porePressureU2", "6"),
    ]:
        if column in table.columns:
            columns[key] = _scale(name, column, units.get(number, "MPa")) * table[column].cast(float).to_numpy()
    ratio = test.cone_surface_quotient
    return columns, {} if ratio is None else {"net_area_ratio": float(ratio)}


def _scale(name: str, column: str, unit: str) -> float:
    """Pascals of a unit."""
    if unit not in _PASCALS:
        raise ValueError(f"{name}: {column} is in {unit!r}, it must be in one of {', '.join(_PASCALS)}")
    return _PASCALS[unit]


def _ags(name: str, test: str | None) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    try:
        from python_ags4 import AGS4
    except ImportError as error:
        raise ImportError("AGS4 files need python-ags4: pip install 'groundwave[ags]'") from error
    tables, _ = AGS4.AGS4_to_dataframe(name)
    if "SCPT" not in tables:
        raise ValueError(f"{name}: there is no group SCPT, but {', '.join(tables)}")
    group = tables["SCPT"]
    units = group[group["HEADING"] == "UNIT"].iloc[0]
    rows = group[group["HEADING"] == "DATA"]
    places = list(dict.fromkeys(rows["LOCA_ID"]))
    if test is None and len(places) > 1 or test is not None and test not in places:
        raise ValueError(f"{name}: test={test!r}, it must be one of {', '.join(places)}")
    rows = rows[rows["LOCA_ID"] == (test or places[0])]

    def column(heading: str) -> np.ndarray:
        numbers = np.array([float(text) if text else np.nan for text in rows[heading]])
        return numbers if heading == "SCPT_DPTH" else numbers * _scale(name, heading, units[heading])

    asked = {
        "depth": "SCPT_DPTH", "cone_resistance": "SCPT_RES", "sleeve_friction": "SCPT_FRES", "pore_pressure": "SCPT_PWP2",
    }
    present = {key: heading for key, heading in asked.items() if heading in rows and rows[heading].any()}
    return {key: column(heading) for key, heading in present.items()}, {"location": test or places[0]}


def shear_speed(
    cpt: xr.Dataset,
    correlation: str,
    *,
    water_depth: float,
    unit_weight: float | np.ndarray,
    net_area_ratio: float | None = None,
) -> xr.Dataset:
    """Shear speeds by a correlation, with its scatter.

    Parameters
    ----------
    cpt : xarray.Dataset
        As `read_cpt` has it.
    correlation : {"robertson2009", "andrus2007", "mcgann2015", "mayne1995"}
        Which of `CORRELATIONS`.
    water_depth : float
        Of the water table below the surface [m].
    unit_weight : float or array-like
        Of the soil [N/m³], at every depth or everywhere.
    net_area_ratio : float, optional
        Of the cone, where pore pressures were measured; that of the file by default.

    Returns
    -------
    xarray.Dataset
        ``shear_speed`` [m/s], ``sigma_ln`` (standard deviation of its logarithm) and the ``behaviour_index`` I_c of Robertson (2009) over
        ``depth``; NaN where the cone felt nothing.

    Examples
    --------
    >>> cpt = xr.Dataset({"cone_resistance": ("depth", [600e3]), "sleeve_friction": ("depth", [15e3])}, coords={"depth": [2.9]})
    >>> found = shear_speed(cpt, "mcgann2015", water_depth=1.0, unit_weight=17e3)
    >>> round(found.shear_speed.item(), 1)
    77.9
    """
    if correlation not in CORRELATIONS:
        raise ValueError(f"correlation={correlation!r}: it must be one of {', '.join(CORRELATIONS)}")
    depth = cpt["depth"].values.astype(float)
    weight = np.broadcast_to(np.asarray(unit_weight, dtype=float), depth.shape)
    if not (weight > 0).all() or not (np.diff(depth) > 0).all() or (depth < 0).any():
        raise ValueError("unit_weight must be above zero, depth must grow from the surface down")
    total = np.cumsum(weight * np.diff(depth, prepend=0.0))
    effective = total - WATER * np.clip(depth - water_depth, 0.0, None)
    if (effective <= 0).any():
        raise ValueError("the effective stress is not above zero: unit_weight is in N/m³, 18e3 for most soils")
    qc, fs = cpt["cone_resistance"].values, cpt["sleeve_friction"].values
    qt = qc
    if "pore_pressure" in cpt:
        ratio = cpt.attrs.get("net_area_ratio") if net_area_ratio is None else net_area_ratio
        if ratio is None:
            raise ValueError("pore pressures were measured: give net_area_ratio of the cone, 0.6 to 0.85")
        # q_t = q_c + u₂ (1 − a)
        qt = qc + (1 - ratio) * np.nan_to_num(cpt["pore_pressure"].values)
    felt = (qt > total) & (fs > 0)
    depth_, qt, qc, fs, net, effective = (
        np.where(felt, values, np.nan) for values in (depth, qt, qc, fs, qt - total, effective)
    )
    ic = _behaviour_index(net, fs, effective)
    named = CORRELATIONS[correlation]
    speed = named.speed(depth=depth_, qt=qt, qc=qc, fs=fs, ic=ic, net=net)
    return xr.Dataset(
        {
            "shear_speed": ("depth", speed, {"units": "m s-1", "long_name": "shear wave speed"}),
            "sigma_ln": ("depth", named.scatter(depth_, speed), {"units": "1", "long_name": "standard deviation of ln c_s"}),
            "behaviour_index": ("depth", ic, {"units": "1", "long_name": "soil behaviour type index I_c"}),
        },
        coords={"depth": cpt["depth"]},
        attrs={"correlation": correlation, "reference": named.source},
    )


def _behaviour_index(net: np.ndarray, fs: np.ndarray, effective: np.ndarray) -> np.ndarray:
    """I_c = √((3.47 − lg Q_tn)² + (lg F_r + 1.22)²), Q_tn by a power of the stress that depends on I_c itself."""
    friction = np.log10(100 * fs / net) + 1.22
    power = np.ones_like(net)
    for _ in range(50):
        normalised = net / ATMOSPHERE * (ATMOSPHERE / effective) ** power
        ic = np.hypot(3.47 - np.log10(normalised), friction)
        # n = 0.381 I_c + 0.05 σ'/p_a − 0.15, at most 1
        power = np.minimum(0.381 * ic + 0.05 * effective / ATMOSPHERE - 0.15, 1.0)
    return ic


def _layers(profile: xr.Dataset, boundaries: Sequence[float]) -> list[tuple[float, float, float]]:
    """Thickness, mean speed by travel time and mean scatter between `boundaries`."""
    edges = np.concatenate([[0.0], np.asarray(boundaries, dtype=float)])
    if not (np.diff(edges) > 0).all():
        raise ValueError("boundaries must grow from the surface down, the first above zero")
    known = profile.dropna("depth")
    depth, layers = known["depth"].values, []
    for top, bottom in zip(edges[:-1], edges[1:]):
        inside = (depth >= top) & (depth < bottom)
        if not inside.any():
            raise ValueError(f"there is no shear speed between {top:g} and {bottom:g} m: move the boundaries")
        slowness = float(np.mean(1.0 / known["shear_speed"].values[inside]))
        layers.append((float(bottom - top), 1.0 / slowness, float(np.mean(known["sigma_ln"].values[inside]))))
    return layers


def soil(
    profile: xr.Dataset,
    boundaries: Sequence[float],
    *,
    half_space: Mapping[str, Any],
    poisson: float | Sequence[float],
    density: float | Sequence[float],
    damping_ratio: float | Sequence[float],
) -> Soil:
    """Layers with the mean shear speed, by travel time, between boundaries.

    Parameters
    ----------
    profile : xarray.Dataset
        As `shear_speed` has it.
    boundaries : sequence of float
        Depths of the lower faces of the layers [m].
    half_space : mapping
        What lies below the last of them, as `Soil` takes it.
    poisson, density, damping_ratio : float or sequence of float
        Of every layer, or of all: ν, ρ [kg/m³], ξ. Below the water table ν is 0.45 to 0.499.

    Returns
    -------
    Soil
        Its layers are named after the correlation.

    Examples
    --------
    >>> profile = xr.Dataset({"shear_speed": ("depth", [100.0, 300.0]), "sigma_ln": ("depth", [0.2, 0.2])}, coords={"depth": [0.5, 1.5]})
    >>> ground = soil(profile, [2.0], poisson=0.4, density=1800.0, damping_ratio=0.02,
    ...               half_space={"shear_speed": 300.0, "poisson": 0.4, "density": 2000.0, "damping_ratio": 0.02})
    >>> round(ground.layers.shear_speed[0].item(), 6)
    150.0
    """
    layers = _layers(profile, boundaries)
    rows = [np.broadcast_to(np.asarray(value, dtype=float), len(layers)) for value in (poisson, density, damping_ratio)]
    return Soil(
        layer=[
            {"thickness": thickness, "shear_speed": speed, "poisson": nu, "density": rho, "damping_ratio": xi}
            for (thickness, speed, _), nu, rho, xi in zip(layers, *(row.tolist() for row in rows))
        ],
        half_space=half_space,
    )


def vary(profile: xr.Dataset, boundaries: Sequence[float]) -> list[dict[str, Any]]:
    """The scatter of the correlation as the list ``vary`` of ``[study]``: a lognormal shear speed for every layer.

    A layer's points are taken to err together, layers each for itself; `correlation` of ``[study]`` joins them.

    Parameters
    ----------
    profile : xarray.Dataset
        As `shear_speed` has it.
    boundaries : sequence of float
        Those `soil` was made with [m].

    Examples
    --------
    >>> profile = xr.Dataset({"shear_speed": ("depth", [100.0, 300.0]), "sigma_ln": ("depth", [0.2, 0.2])}, coords={"depth": [0.5, 1.5]})
    >>> vary(profile, [1.0])
    [{'key': 'soil.layer.0.shear_speed', 'kind': 'lognormal', 'median': 100.0, 'sigma_ln': 0.2}]
    """
    return [
        {"key": f"soil.layer.{i}.shear_speed", "kind": "lognormal", "median": speed, "sigma_ln": sigma}
        for i, (_, speed, sigma) in enumerate(_layers(profile, boundaries))
    ]


def read_models(path: str | PathLike[str], damping_ratio: float | None = None) -> list[Soil]:
    """Reads layered models as geopsy and dinver write them (``gpdcreport``).

    For each model a line with the number of layers, the half-space included, then a line for each: thickness [m], c_p, c_s [m/s],
    density [kg/m³] and, where given, quality factors Q_p and Q_s; the last one's thickness is 0. Lines with ``#`` are skipped.

    Parameters
    ----------
    path : path-like
        The file.
    damping_ratio : float, optional
        ξ of all layers, where the models have no quality factors; with them, ξ = 1/(2 Q).

    Returns
    -------
    list of Soil
        In their order.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder) / "best.txt"
    ...     _ = file.write_text("# Layered model 1: value=0.1\\n2\\n3.0 400 120 1700\\n0 800 300 2000\\n")
    ...     read_models(file, damping_ratio=0.02)[0].layers.shear_speed.values
    array([120., 300.])
    """
    name = os.fspath(path)
    with open(name, encoding="utf-8") as file:
        lines = [(number, line.split("#")[0].split()) for number, line in enumerate(file, 1)]
    lines = [(number, fields) for number, fields in lines if fields]
    models, at = [], 0
    while at < len(lines):
        number, fields = lines[at]
        if len(fields) != 1 or not fields[0].isdigit() or int(fields[0]) < 1:
            raise ValueError(f"{name}:{number}: found {' '.join(fields)}, it must be the number of layers of a model")
        count = int(fields[0])
        rows = lines[at + 1 : at + 1 + count]
        if len(rows) < count:
            raise ValueError(f"{name}:{number}: {count} layers are announced, {len(rows)} follow")
        models.append(_model([_material(name, row, damping_ratio) for row in rows]))
        at += 1 + count
    if not models:
        raise ValueError(f"{name}: there is no model in it")
    return models


def _material(name: str, row: tuple[int, list[str]], damping_ratio: float | None) -> dict[str, float]:
    number, fields = row
    try:
        values = [float(field) for field in fields]
    except ValueError:
        values = []
    if len(values) not in (4, 6):
        raise ValueError(f"{name}:{number}: found {' '.join(fields)}, it must be thickness, c_p, c_s, density, with or without Q_p, Q_s")
    thickness, pressure, shear, density = values[:4]
    material = {"thickness": thickness, "pressure_speed": pressure, "shear_speed": shear, "density": density}
    if len(values) == 6:
        return material | {"damping_ratio_pressure": 0.5 / values[4], "damping_ratio": 0.5 / values[5]}
    if damping_ratio is None:
        raise ValueError(f"{name}:{number}: there are no quality factors: give damping_ratio")
    return material | {"damping_ratio": damping_ratio}


def _model(materials: list[dict[str, float]]) -> Soil:
    *layers, half_space = materials
    return Soil(layer=layers, half_space={key: value for key, value in half_space.items() if key != "thickness"})
