"""Ground, track and train by themselves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr

from . import _core
from .results import warn

__all__ = ["Soil", "Springs", "Track", "Train"]


class _Table:
    """A table of a case, checked when it is made: as a name of the library, or as a dictionary."""

    _key: str
    # what stands beside other keys for a name of the library
    _named = "library"

    def __init__(self, source: str | Mapping[str, Any] | None, keys: Mapping[str, Any]) -> None:
        given = {key: value for key, value in keys.items() if value is not None}
        if isinstance(source, str):
            self.table: str | dict[str, Any] = {self._named: source, **given} if given else source
        else:
            self.table = {**(source or {}), **given}
        self._found = _core.tables(_core.toml({self._key: self.table}), ".", {})
        warn(self._found["concerns"])

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.table!r})"


class Soil(_Table):
    """Layered ground.

    Parameters
    ----------
    source : str or mapping, optional
        Name of a soil of the library (see `library`) or of a TOML file in the working folder (``"clay"`` for ``clay.toml``), or the
        table ``[soil]`` of a case.
    layer : sequence of mappings, optional
        Layers, top first: ``thickness`` [m], ``density`` [kg/m³], ``shear_speed`` [m/s] with ``poisson`` or ``pressure_speed``, or
        ``young`` [Pa] with ``poisson``; ``damping_ratio`` or ``loss_factor``; ``name``.
    half_space : mapping, optional
        What lies below them: the same without a thickness.
    base : {"rigid"}, optional
        Rock instead of a half-space.
    solver : mapping, optional
        ``{"kind": "direct-stiffness"}`` (the default), ``"thin-layer"``, ``"transfer-matrix"``, ``"flexibility"``; with ``verify`` every
        answer is held against that of another one.

    Attributes
    ----------
    table : str or dict
        What it was made of.

    Raises
    ------
    CaseError
        A soil that cannot be, with every faulty key.

    Examples
    --------
    >>> soil = Soil(layer=[{"thickness": 2.0, "shear_speed": 120.0, "poisson": 0.35, "density": 1500.0, "damping_ratio": 0.03}],
    ...             half_space={"shear_speed": 250.0, "poisson": 0.35, "density": 1800.0, "damping_ratio": 0.03})
    >>> soil.layers.shear_speed.values
    array([120., 250.])
    """

    _key = "soil"

    def __init__(
        self,
        source: str | Mapping[str, Any] | None = None,
        *,
        layer: Sequence[Mapping[str, Any]] | None = None,
        half_space: Mapping[str, Any] | None = None,
        base: str | None = None,
        solver: Mapping[str, Any] | None = None,
    ) -> None:
        super().__init__(source, {"layer": layer, "half_space": half_space, "base": base, "solver": solver})

    @property
    def layers(self) -> xr.Dataset:
        """Layers and half-space over the depth of their upper faces: ``thickness``, speeds of shear, pressure and Rayleigh waves,
        ``density``, ``poisson``, ``loss_factor``.

        Examples
        --------
        >>> Soil("lamprea2022_layered").layers.rayleigh_speed.attrs["units"]
        'm s-1'
        """
        units = {
            "thickness": "m", "shear_speed": "m s-1", "pressure_speed": "m s-1", "rayleigh_speed": "m s-1",
            "density": "kg m-3", "poisson": "1", "loss_factor": "1",
        }
        rows = self._found["layers"]
        depth = np.concatenate([[0.0], np.cumsum([row["thickness"] for row in rows])[:-1]])
        return xr.Dataset(
            {key: ("depth", [row[key] for row in rows], {"units": unit}) for key, unit in units.items()},
            coords={"depth": ("depth", depth, {"units": "m", "long_name": "depth of the upper face"})},
            attrs={"base": "rigid" if self._found["rigid"] else "half-space"},
        )

    def compliance(self, k: Any, f: Any) -> xr.Dataset:
        """Displacements of the surface under traction waves, G(k, ω).

        Parameters
        ----------
        k : array-like or slice
            Wavenumbers [rad/m].
        f : array-like or slice
            Frequencies [Hz].

        Returns
        -------
        xarray.Dataset
            Complex ``u_zz``, ``u_xx``, ``u_xz``, ``u_yy`` [m/Pa] over ``frequency`` and ``k``.

        Examples
        --------
        >>> Soil("lamprea2022_layered").compliance(k=[0.1, 1.0], f=[5.0, 10.0, 20.0]).u_zz.shape
        (3, 2)
        """
        from .studies import surface_compliance

        return surface_compliance(soil=self, k=k, frequencies=f)

    def equivalent_stiffness(self, beta: Any, f: Any, half_width: float, compatibility: str = "mean") -> xr.Dataset:
        """Stiffness of the ground under a strip, k_eq(β, ω).

        Parameters
        ----------
        beta : array-like or slice
            Wavenumbers along the strip [rad/m].
        f : array-like or slice
            Frequencies [Hz].
        half_width : float
            Half the width of the strip [m].
        compatibility : {"mean", "centre"}
            Whether the strip follows the mean of the ground's displacement over its width or that of its centre.

        Returns
        -------
        xarray.Dataset
            Complex ``k_eq`` [N/m²] over ``omega`` [rad/s] and ``beta``.

        Examples
        --------
        >>> table = Soil("lamprea2022_layered").equivalent_stiffness(beta=[0.2, 1.0], f=[10.0], half_width=1.25)
        >>> table.k_eq.dims
        ('omega', 'beta')
        """
        from .studies import equivalent_stiffness

        track = {"kind": "none", "contact": {"half_width": half_width, "compatibility": compatibility}}
        return equivalent_stiffness(soil=self, track=track, beta=beta, frequencies=f)

    def dispersion(self, f: Any, modes: int = 3, wave: str | None = None, shapes: Mapping[str, Any] | None = None) -> xr.Dataset:
        """Waves that travel along the ground by themselves.

        Parameters
        ----------
        f : array-like or slice
            Frequencies [Hz], ascending.
        modes : int
            How many modes, the slowest first.
        wave : {"rayleigh", "love"}, optional
            Which waves; Rayleigh by default.
        shapes : mapping, optional
            How the ground moves in each mode: at ``frequencies`` [Hz] and depths ``z`` [m].

        Returns
        -------
        xarray.Dataset
            ``phase_velocity``, ``group_velocity``, ``attenuation``, … over ``frequency`` and ``mode``; what has no mode is NaN.

        Examples
        --------
        >>> Soil("lamprea2022_layered").dispersion(f=[10.0, 20.0], modes=2).phase_velocity.shape
        (2, 2)
        """
        from .studies import dispersion

        return dispersion(soil=self, frequencies=f, modes=modes, wave=wave, shapes=shapes)


class Springs(_Table):
    """Springs under a track, instead of ground: the table ``[foundation]``.

    Parameters
    ----------
    kind : {"winkler", "filonenko-borodich", "hetenyi", "pasternak", "kerr", "rigid"} or mapping
        Which springs, or the whole table.
    stiffness : float, optional
        Of the springs, per metre of track [N/m²].
    damping : float, optional
        Viscous, per metre of track [N s/m²].
    loss_factor : float, optional
        Hysteretic.
    element : mapping, optional
        Instead of the three: ``{"kind": "zener", …}``.
    tension : float, optional
        Of the membrane of ``"filonenko-borodich"`` [N].
    bending_stiffness : float, optional
        Of the plate of ``"hetenyi"`` [N m²].
    shear : float, optional
        Of the layer of ``"pasternak"`` and ``"kerr"`` [N].
    upper_stiffness : float, optional
        Of the upper springs of ``"kerr"`` [N/m²].

    Examples
    --------
    >>> Springs("winkler", stiffness=1.8e8, loss_factor=0.1)
    Springs({'kind': 'winkler', 'stiffness': 180000000.0, 'loss_factor': 0.1})
    """

    _key = "foundation"
    _named = "kind"

    def __init__(
        self,
        kind: str | Mapping[str, Any],
        *,
        stiffness: float | str | None = None,
        damping: float | str | None = None,
        loss_factor: float | None = None,
        element: Mapping[str, Any] | None = None,
        tension: float | str | None = None,
        bending_stiffness: float | str | None = None,
        shear: float | str | None = None,
        upper_stiffness: float | str | None = None,
    ) -> None:
        keys = {
            "stiffness": stiffness, "damping": damping, "loss_factor": loss_factor, "element": element, "tension": tension,
            "bending_stiffness": bending_stiffness, "shear": shear, "upper_stiffness": upper_stiffness,
        }
        super().__init__({"kind": kind} if isinstance(kind, str) else kind, keys)


class Track(_Table):
    """A track: a table ``[track]``. Numbers are those of the whole track unless ``rails=1``.

    Parameters
    ----------
    source : str or mapping, optional
        Name of a track of the library (see `library`), or of a TOML file in the working folder; with other keys, that track with
        these changed. Or the whole table.
    kind : {"ballasted", "slab", "beam", "none"}, optional
        Which track.
    rails : {1, 2}, optional
        How many rails the numbers stand for.
    rail, pad, sleeper, ballast, sub_ballast, under_sleeper_pad, mat, slab, beam : mapping, optional
        Its parts: ``rail={"bending_stiffness": …, "mass": …}`` or ``{"section": "60E1"}``, ``pad={"stiffness": …, "damping": …}``, ….
    contact : mapping, optional
        With the ground: ``half_width`` [m], ``compatibility``.
    load : mapping, optional
        Without a track: how each axle presses on the ground.
    support : mapping, optional
        Supports that stand apart: ``spacing``, ``width`` [m].
    section : sequence of mappings, optional
        Sections one after another, each with what differs in it and its ``length``.

    Examples
    --------
    >>> Track("lamprea2022_ballasted", pad={"stiffness": 3.0e8}).layout
    'continuous'
    """

    _key = "track"

    def __init__(
        self,
        source: str | Mapping[str, Any] | None = None,
        *,
        kind: str | None = None,
        rails: int | None = None,
        rail: Mapping[str, Any] | None = None,
        pad: Mapping[str, Any] | None = None,
        sleeper: Mapping[str, Any] | None = None,
        ballast: Mapping[str, Any] | None = None,
        sub_ballast: Mapping[str, Any] | None = None,
        under_sleeper_pad: Mapping[str, Any] | None = None,
        mat: Mapping[str, Any] | None = None,
        slab: Mapping[str, Any] | None = None,
        beam: Mapping[str, Any] | None = None,
        contact: Mapping[str, Any] | None = None,
        load: Mapping[str, Any] | None = None,
        support: Mapping[str, Any] | None = None,
        section: Sequence[Mapping[str, Any]] | None = None,
    ) -> None:
        keys = {
            "kind": kind, "rails": rails, "rail": rail, "pad": pad, "sleeper": sleeper, "ballast": ballast,
            "sub_ballast": sub_ballast, "under_sleeper_pad": under_sleeper_pad, "mat": mat, "slab": slab, "beam": beam,
            "contact": contact, "load": load, "support": support, "section": section,
        }
        super().__init__(source, keys)

    @property
    def layout(self) -> str:
        """How it stands: ``"continuous"``, ``"discrete"`` on supports that stand apart, or ``"varying"`` in sections."""
        return self._found["layout"]


class Train(_Table):
    """A train: a table ``[train]``.

    Parameters
    ----------
    source : str or mapping, optional
        Name of a vehicle of the library (see `library`) or of a TOML file in the working folder, or the whole table.
    axles : sequence of mappings, optional
        ``{"position": …, "load": …}`` of each: metres behind the first, newtons.
    vehicle : str or sequence of mappings, optional
        A vehicle of the library, or several one behind the other: ``name``, ``count``, ``reversed``.
    count : int, optional
        How many in a row.
    reversed : bool, optional
        Whether the last axle leads.
    length, overhang : float, optional
        Over couplers; from there to the first axle [m].
    model : {"unsprung", "two", "four", "five", "ten"}, optional
        Which bodies follow a rough rail.
    unsprung_mass : float, optional
        Of each wheelset [kg].
    body, bogie, wheelset, primary, secondary : mapping, optional
        A vehicle on bogies.
    wheel_rail : mapping, optional
        Contact of each wheelset: ``stiffness`` [N/m], or ``radius`` [m] and ``tread``.

    Examples
    --------
    >>> train = Train("en1991_hslm_a1")
    >>> len(train.loads), float(train.loads[0])
    (50, 170000.0)
    """

    _key = "train"
    _named = "vehicle"

    def __init__(
        self,
        source: str | Mapping[str, Any] | None = None,
        *,
        axles: Sequence[Mapping[str, Any]] | None = None,
        vehicle: str | Sequence[Mapping[str, Any]] | None = None,
        count: int | None = None,
        reversed: bool | None = None,
        length: float | str | None = None,
        overhang: float | str | None = None,
        model: str | None = None,
        unsprung_mass: float | str | None = None,
        body: Mapping[str, Any] | None = None,
        bogie: Mapping[str, Any] | None = None,
        wheelset: Mapping[str, Any] | None = None,
        primary: Mapping[str, Any] | None = None,
        secondary: Mapping[str, Any] | None = None,
        wheel_rail: Mapping[str, Any] | None = None,
    ) -> None:
        keys = {
            "axles": axles, "vehicle": vehicle, "count": count, "reversed": reversed, "length": length, "overhang": overhang,
            "model": model, "unsprung_mass": unsprung_mass, "body": body, "bogie": bogie, "wheelset": wheelset,
            "primary": primary, "secondary": secondary, "wheel_rail": wheel_rail,
        }
        super().__init__(source, keys)

    @property
    def positions(self) -> np.ndarray:
        """Of the axles along the train [m], the leading one first."""
        return np.array(self._found["positions"])

    @property
    def loads(self) -> np.ndarray:
        """Of the axles [N], positive down."""
        return np.array(self._found["loads"])
