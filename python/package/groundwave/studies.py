"""Every question as a function: its arguments are the keys it has in a case file.

Numbers are SI, or texts with a unit such as ``"250 km/h"``. Where several values may stand, a ``slice(from, to, step)`` stands for
``{from, to, step}``, and where a span, ``slice(from, to)``. A key that Python keeps for itself has an underscore: ``from_``.

The file is long because it is the list of all questions with every key.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any

import numpy as np
import xarray as xr

from .case import Case, Progress
from .tables import Soil, Springs, Track, Train

__all__ = [
    "critical_speed",
    "dispersion",
    "track_response",
    "contour",
    "ground_at_depth",
    "receptance",
    "decay_rate",
    "transition",
    "passage",
    "free_field",
    "equivalent_stiffness",
    "surface_compliance",
]

Number = float | str
Values = Sequence[Number] | np.ndarray | slice | Mapping[str, Any]
Span = slice | Mapping[str, Any]
Ground = Soil | str | Mapping[str, Any]
Springs_ = Springs | Mapping[str, Any]
Track_ = Track | str | Mapping[str, Any]
Train_ = Train | str | Mapping[str, Any]


def _ask(study: str, keys: Mapping[str, Any], progress: Progress | None, **rest: Any) -> xr.Dataset:
    """The answer to one question; `rest` are the tables of the case and where files beside it are."""
    folder = rest.pop("folder", None)
    tree = Case({"title": study, **rest, study: keys}, folder=folder).run(progress)
    return tree[study].to_dataset().assign_attrs({**tree.attrs, **tree[study].attrs})


def critical_speed(
    *,
    speeds: Values,
    line_speed: Number | None = None,
    accuracy: Number | None = None,
    soil: Ground | None = None,
    foundation: Springs_ | None = None,
    track: Track_ | None = None,
    train: Train_ | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Largest rail deflections against speed, and the critical speed.

    Parameters
    ----------
    speeds : array-like or slice
        v [m/s], ascending.
    line_speed : float or str, optional
        At which trains are to run [m/s]: amplification there, and its share of the critical speed.
    accuracy : float or str, optional
        Wanted error of deflections relative to that under an axle [1]; 1e-5 by default. 1e-3 takes half the time.
    soil : Soil, str or mapping, optional
        Layered ground: a `Soil`, its table, or a name of the library.
    foundation : Springs or mapping, optional
        Springs instead of ground: a `Springs` or its table.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    train : Train, str or mapping, optional
        A `Train`, its table, or a name of the library.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        ``max_down``, ``max_up`` [m], ``amplification`` over ``speed``; answers: ``critical_speed``, ``max_down``,
        ``amplification``, ….

    Examples
    --------
    >>> import groundwave as gw
    >>> curve = gw.critical_speed(soil="lamprea2022_half_space", track="lamprea2022_slab",
    ...                           train="lamprea2022_axle", speeds=[90, 105, 120, 135])
    >>> curve.max_down.idxmax("speed").item()
    105.0
    """
    keys = {
        "speeds": speeds, "line_speed": line_speed, "accuracy": accuracy,
    }
    return _ask("critical_speed", keys, progress, soil=soil, foundation=foundation, track=track, train=train)


def dispersion(
    *,
    frequencies: Values,
    modes: int | None = None,
    wave: str | None = None,
    shapes: Mapping[str, Any] | None = None,
    soil: Ground | None = None,
    track: Track_ | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Waves that travel along the ground and along the track by themselves.

    Parameters
    ----------
    frequencies : array-like or slice
        f [Hz], above zero, ascending.
    modes : int, optional
        How many modes, the slowest first; 3 by default.
    wave : {"rayleigh", "love"}, optional
        Which waves; Rayleigh by default.
    shapes : mapping, optional
        How the ground moves over depth in each mode.
    soil : Soil, str or mapping, optional
        Layered ground: a `Soil`, its table, or a name of the library.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        ``phase_velocity``, ``group_velocity`` [m/s], ``attenuation``, … over ``frequency`` and ``mode``; what has no mode is
        NaN.

    Examples
    --------
    >>> import groundwave as gw
    >>> waves = gw.dispersion(soil="lamprea2022_layered", frequencies=slice(5, 50, 5), modes=2)
    >>> waves.phase_velocity.dims
    ('frequency', 'mode')
    """
    keys = {
        "frequencies": frequencies, "modes": modes, "wave": wave, "shapes": shapes,
    }
    return _ask("dispersion", keys, progress, soil=soil, track=track)


def track_response(
    *,
    speeds: Values,
    line_speed: Number | None = None,
    x: Span | None = None,
    spacing: Number | None = None,
    at: Values | None = None,
    harmonic: Number | None = None,
    frequencies: Values | None = None,
    method: str | None = None,
    verify: str | None = None,
    soil: Ground | None = None,
    foundation: Springs_ | None = None,
    track: Track_ | None = None,
    train: Train_ | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Shapes of the rail and of the ground under it, or histories over supports that stand apart.

    Parameters
    ----------
    speeds : array-like or slice
        v [m/s].
    line_speed : float or str, optional
        At which trains are to run [m/s]: added to the speeds, with the amplification there on a track without separate
        supports.
    x : slice or mapping, optional
        x′ [m]; by default 40 m behind the train to 20 m ahead of it.
    spacing : float or str, optional
        Spacing [m], 0.1 by default, 0.02 over supports.
    at : array-like, optional
        Over supports: where the rail is watched [m] from a support; over it and in the middle of the bay by default.
    harmonic : float or str, optional
        Over supports: frequency [Hz] with which all axle loads oscillate; constant loads by default.
    frequencies : array-like or slice, optional
        Over supports: f [Hz], above zero, ascending, of spectra of the rail under the leading axle.
    method : {"adaptive", "closed-form", "residues", "boundary-values", "fourier", "filon", "floquet", "dirac-comb", "point-source", "moving-green", "transfer-matrix", "coupled", "finite-elements"}, optional
        How the rail is asked; the best for its track by default.
    verify : {"adaptive", "closed-form", "residues", "boundary-values", "fourier", "filon", "floquet", "dirac-comb", "point-source", "moving-green", "transfer-matrix", "coupled", "finite-elements"}, optional
        Another method, whose difference is reported.
    soil : Soil, str or mapping, optional
        Layered ground: a `Soil`, its table, or a name of the library.
    foundation : Springs or mapping, optional
        Springs instead of ground: a `Springs` or its table.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    train : Train, str or mapping, optional
        A `Train`, its table, or a name of the library.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        ``rail``, ``base`` [m] over ``speed`` and ``x``; over supports ``rail`` over ``speed``, ``at`` and ``distance`` the
        train has come, and the harmonics of the support passing.

    Examples
    --------
    >>> import groundwave as gw
    >>> shapes = gw.track_response(soil="lamprea2022_half_space", track="lamprea2022_slab",
    ...                            train="lamprea2022_axle", speeds=[50.0], x=slice(-10, 5))
    >>> shapes.rail.dims
    ('speed', 'x')
    """
    keys = {
        "speeds": speeds, "line_speed": line_speed, "x": x, "spacing": spacing, "at": at, "harmonic": harmonic,
        "frequencies": frequencies, "method": method, "verify": verify,
    }
    return _ask("track_response", keys, progress, soil=soil, foundation=foundation, track=track, train=train)


def contour(
    *,
    speeds: Values,
    x: Span,
    y: Span,
    spacing: Number,
    quantities: Sequence[str] | None = None,
    clearance: Number | None = None,
    soil: Ground | None = None,
    track: Track_ | None = None,
    train: Train_ | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Maps of the ground's surface around the train.

    Parameters
    ----------
    speeds : array-like or slice
        v [m/s].
    x : slice or mapping
        x′ [m], positive ahead of the leading axle.
    y : slice or mapping
        y [m], from the centre line of the track.
    spacing : float or str
        [m].
    quantities : sequence of str, optional
        What to map; vertical displacement by default.
    clearance : float or str, optional
        Distance to the periodic images [m]; by default from damping and wavelength.
    soil : Soil, str or mapping, optional
        Layered ground: a `Soil`, its table, or a name of the library.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    train : Train, str or mapping, optional
        A `Train`, its table, or a name of the library.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        A field over ``y`` and ``x`` for each speed, seen from the leading axle.

    Examples
    --------
    >>> import groundwave as gw
    >>> maps = gw.contour(soil="lamprea2022_half_space", track="lamprea2022_slab", train="lamprea2022_axle",
    ...                   speeds=[60.0], x=slice(-10, 10), y=slice(-10, 10), spacing=2.0)
    >>> maps.sizes["x"], maps.sizes["y"]
    (11, 11)
    """
    keys = {
        "speeds": speeds, "x": x, "y": y, "spacing": spacing, "quantities": quantities, "clearance": clearance,
    }
    return _ask("contour", keys, progress, soil=soil, track=track, train=train)


def ground_at_depth(
    *,
    z: Values,
    speeds: Values | None = None,
    y: Values | None = None,
    x: Span | None = None,
    spacing: Number | None = None,
    threshold_strain: Number | None = None,
    soil: Ground | None = None,
    track: Track_ | None = None,
    train: Train_ | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Displacements, strains and stresses of the ground below the surface.

    Parameters
    ----------
    z : array-like or slice
        Depths [m] below the surface, ascending, from 0.05 m.
    speeds : array-like or slice, optional
        v [m/s]; the train at rest is computed as well, and alone where this is left out.
    y : array-like or slice, optional
        Distances [m] from the centre line of the track; 0 by default.
    x : slice or mapping, optional
        x′ [m], positive ahead of the leading axle; from 10 m behind the train to 10 m ahead of it by default.
    spacing : float or str, optional
        Along x′ [m]; 0.25 by default.
    threshold_strain : float or str, optional
        Cyclic shear strain from which on the soil softens; 1e-4 by default.
    soil : Soil, str or mapping, optional
        Layered ground: a `Soil`, its table, or a name of the library.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    train : Train, str or mapping, optional
        A `Train`, its table, or a name of the library.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        Largest values over depth, and the whole field over ``speed``, ``z``, ``y`` and ``x``.

    Examples
    --------
    >>> import groundwave as gw
    >>> field = gw.ground_at_depth(soil="lamprea2022_half_space", track="lamprea2022_slab",
    ...                            train={"axles": [{"position": 0.0, "load": 10e3}]},
    ...                            z=[0.5, 1.0], x=slice(-2, 2), spacing=1.0)
    >>> field.sizes["z"]
    2
    """
    keys = {
        "speeds": speeds, "z": z, "y": y, "x": x, "spacing": spacing, "threshold_strain": threshold_strain,
    }
    return _ask("ground_at_depth", keys, progress, soil=soil, track=track, train=train)


def receptance(
    *,
    frequencies: Values,
    from_: Number | None = None,
    x: Values | None = None,
    receivers: Values | None = None,
    map: Mapping[str, Any] | None = None,
    method: str | None = None,
    verify: str | None = None,
    soil: Ground | None = None,
    foundation: Springs_ | None = None,
    track: Track_ | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Rail and ground under a standing harmonic load.

    Parameters
    ----------
    frequencies : array-like or slice
        f [Hz], above zero, ascending.
    from_ : float or str, optional
        Where the force stands [m], from a support, or from the first change of section; 0 by default.
    x : array-like, optional
        Where the rail answers [m], from the same; under the force alone by default.
    receivers : array-like, optional
        Distances from the centre line of the track [m]; none by default.
    map : mapping, optional
        The ground's surface around the force; none by default.
    method : {"adaptive", "closed-form", "residues", "boundary-values", "fourier", "filon", "floquet", "dirac-comb", "point-source", "moving-green", "transfer-matrix", "coupled", "finite-elements"}, optional
        How the rail is asked; the best for its track by default.
    verify : {"adaptive", "closed-form", "residues", "boundary-values", "fourier", "filon", "floquet", "dirac-comb", "point-source", "moving-green", "transfer-matrix", "coupled", "finite-elements"}, optional
        Another way, whose difference is reported.
    soil : Soil, str or mapping, optional
        Layered ground: a `Soil`, its table, or a name of the library.
    foundation : Springs or mapping, optional
        Springs instead of ground: a `Springs` or its table.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        Complex ``rail`` [m/N] over ``frequency`` (and ``x``), ``ground`` over ``receiver`` and ``frequency``.

    Examples
    --------
    >>> import groundwave as gw
    >>> answer = gw.receptance(soil="lamprea2022_half_space", track="lamprea2022_slab", frequencies=[10.0, 20.0])
    >>> answer.rail.dtype
    dtype('complex128')
    """
    keys = {
        "frequencies": frequencies, "from": from_, "x": x, "receivers": receivers, "map": map, "method": method, "verify":
        verify,
    }
    return _ask("receptance", keys, progress, soil=soil, foundation=foundation, track=track)


def decay_rate(
    *,
    frequencies: Values,
    method: str | None = None,
    from_: Number | None = None,
    rail: str | None = None,
    verify: str | None = None,
    soil: Ground | None = None,
    foundation: Springs_ | None = None,
    track: Track_ | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """How fast vibration dies away along the rail.

    Parameters
    ----------
    frequencies : array-like or slice
        f [Hz], above zero, ascending.
    method : {"floquet", "exact-receptance", "en15461"}, optional
        Which decay rate; that of the free wave by default.
    from_ : float or str, optional
        Where the force stands [m] from a support; in the middle of a bay by default.
    rail : {"adaptive", "closed-form", "residues", "boundary-values", "fourier", "filon", "floquet", "dirac-comb", "point-source", "moving-green", "transfer-matrix", "coupled", "finite-elements"}, optional
        How the rail is asked; the best for its track by default.
    verify : {"adaptive", "closed-form", "residues", "boundary-values", "fourier", "filon", "floquet", "dirac-comb", "point-source", "moving-green", "transfer-matrix", "coupled", "finite-elements"}, optional
        Another way to ask it, whose difference is reported.
    soil : Soil, str or mapping, optional
        Layered ground: a `Soil`, its table, or a name of the library.
    foundation : Springs or mapping, optional
        Springs instead of ground: a `Springs` or its table.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        ``decay`` [dB/m] over ``frequency``.

    Examples
    --------
    >>> import groundwave as gw
    >>> rail = {"bending_stiffness": 6.4e6, "mass": 60.0}
    >>> rates = gw.decay_rate(foundation=gw.Springs("winkler", stiffness=1.8e8, loss_factor=0.2),
    ...                       track=gw.Track(kind="beam", beam=rail), frequencies=[50.0, 1000.0])
    >>> bool(rates.decay[0] > rates.decay[1])
    True
    """
    keys = {
        "frequencies": frequencies, "method": method, "from": from_, "rail": rail, "verify": verify,
    }
    return _ask("decay_rate", keys, progress, soil=soil, foundation=foundation, track=track)


def transition(
    *,
    frequencies: Values,
    along: Values | None = None,
    from_: Number | None = None,
    x: Span | None = None,
    spacing: Number | None = None,
    method: str | None = None,
    verify: str | None = None,
    foundation: Springs_ | None = None,
    track: Track_ | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """What a change of track does to waves along the rail.

    Parameters
    ----------
    frequencies : array-like or slice
        f [Hz], above zero, ascending.
    along : array-like, optional
        f [Hz] at which the receptance is drawn along the rail; none by default.
    from_ : float or str, optional
        Where the force of these stands [m] from the first change of section; half a metre before it by default.
    x : slice or mapping, optional
        Where they are drawn [m] from the first change; 15 m before it to 15 m behind by default.
    spacing : float or str, optional
        Spacing [m], 0.05 by default.
    method : {"adaptive", "closed-form", "residues", "boundary-values", "fourier", "filon", "floquet", "dirac-comb", "point-source", "moving-green", "transfer-matrix", "coupled", "finite-elements"}, optional
        How the rail is asked; the best for its track by default.
    verify : {"adaptive", "closed-form", "residues", "boundary-values", "fourier", "filon", "floquet", "dirac-comb", "point-source", "moving-green", "transfer-matrix", "coupled", "finite-elements"}, optional
        Another method for the receptances along the rail, whose difference is reported.
    foundation : Springs or mapping, optional
        Springs instead of ground: a `Springs` or its table.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        ``reflected``, ``transmitted`` power over ``frequency``; with ``along`` the rail over ``frequency`` and ``x``.

    Examples
    --------
    >>> import groundwave as gw
    >>> rail = {"bending_stiffness": 6.4e6, "mass": 60.0}
    >>> track = gw.Track(kind="beam", beam=rail, support={"spacing": 0.6}, section=[{}, {"support": {"spacing": 0.6}}])
    >>> power = gw.transition(foundation=gw.Springs("winkler", stiffness=1.8e8), track=track, frequencies=[400.0])
    >>> bool(abs(power.transmitted[0] - 1) < 1e-6)
    True
    """
    keys = {
        "frequencies": frequencies, "along": along, "from": from_, "x": x, "spacing": spacing, "method": method, "verify":
        verify,
    }
    return _ask("transition", keys, progress, foundation=foundation, track=track)


def passage(
    *,
    from_: Number,
    to: Number,
    speed: Number | None = None,
    speeds: Values | None = None,
    at: Values | None = None,
    span: Span | None = None,
    defect: Sequence[Mapping[str, Any]] | None = None,
    hanging_sleeper: Sequence[Mapping[str, Any]] | None = None,
    missing_sleepers: Sequence[int] | None = None,
    contact: str | None = None,
    start: str | None = None,
    ramp: Number | None = None,
    damping: Mapping[str, Any] | None = None,
    frequencies: Span | None = None,
    elements_per_bay: int | None = None,
    step: Number | None = None,
    step_length: Number | None = None,
    ends: Mapping[str, Any] | None = None,
    alpha: Number | None = None,
    foundation: Springs_ | None = None,
    track: Track_ | None = None,
    train: Train_ | None = None,
    irregularity: Mapping[str, Any] | None = None,
    folder: str | PathLike[str] | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """A train passes in time: contact that lets go, defects, hanging sleepers, changes of track.

    Parameters
    ----------
    from_ : float or str
        Where the leading axle stands at first [m], x as its supports have it: one at 0, or the first change of section.
    to : float or str
        Where it stands at last [m].
    speed : float or str, optional
        v [m/s].
    speeds : array-like or slice, optional
        Several of them instead [m/s].
    at : array-like, optional
        Where rail and sleepers are watched [m].
    span : slice or mapping, optional
        What of the track is computed [m]; by default from behind the last axle to ahead of the first one, with 18 m beyond
        both, 30 m where something strikes.
    defect : sequence of mappings, optional
        Defects of the rail and of wheels.
    hanging_sleeper : sequence of mappings, optional
        Sleepers that do not reach their bed.
    missing_sleepers : sequence of int, optional
        Numbers of supports that are not there: number n stands at x = n × spacing; of sections, 0 is the first behind the
        first change.
    contact : {"non-linear", "linear"}, optional
        Whether wheels may leave the rail; "non-linear" by default.
    start : {"static", "ramp"}, optional
        "static" where wheels have a mass, "ramp" for constant loads by default.
    ramp : float or str, optional
        Way over which a start by "ramp" takes hold, or [irregularity] under wheels that start at rest [m]; 12 by default.
    damping : mapping, optional
        Damping of the track in proportion to mass and stiffness, besides its own; none by default.
    frequencies : slice or mapping, optional
        Lowest and highest frequency of interest [Hz], for third octaves of the contact force; 5 to 500 Hz by default.
    elements_per_bay : int, optional
        Finite elements between two supports, or on 0.6 m of a continuous track; 8 by default.
    step : float or str, optional
        Δt [s]; by default what the profiles and frequencies need.
    step_length : float or str, optional
        v Δt [m] instead.
    ends : mapping, optional
        Of the rail; "pinned" by default.
    alpha : float or str, optional
        α of Hilber, Hughes & Taylor, −1/3 to 0; 0 by default, without damping by the steps.
    foundation : Springs or mapping, optional
        Springs instead of ground: a `Springs` or its table.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    train : Train, str or mapping, optional
        A `Train`, its table, or a name of the library.
    irregularity : mapping, optional
        Roughness of the rail: a spectrum or a profile, a table ``[irregularity]``.
    folder : path-like, optional
        Where files beside the case are looked for; the working folder by default.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        Histories of contact forces and of what was asked, envelopes along the track.

    Examples
    --------
    >>> import groundwave as gw
    >>> rail = {"bending_stiffness": 6.4e6, "mass": 60.0}
    >>> passed = gw.passage(foundation=gw.Springs("winkler", stiffness=1.8e8, damping=2e5), track=gw.Track(kind="beam", beam=rail),
    ...                     train="lamprea2022_axle", speed="100 km/h", from_=0.0, to=20.0, at=[15.0])
    >>> "time" in passed.dims
    True
    """
    keys = {
        "from": from_, "to": to, "speed": speed, "speeds": speeds, "at": at, "track": span, "defect": defect,
        "hanging_sleeper": hanging_sleeper, "missing_sleepers": missing_sleepers, "contact": contact, "start": start, "ramp":
        ramp, "damping": damping, "frequencies": frequencies, "elements_per_bay": elements_per_bay, "step": step,
        "step_length": step_length, "ends": ends, "alpha": alpha,
    }
    return _ask("passage", keys, progress, foundation=foundation, track=track, train=train, irregularity=irregularity, folder=folder)


def free_field(
    *,
    speed: Number,
    receivers: Values,
    passage_time: Number | None = None,
    components: str | None = None,
    frequencies: Span | None = None,
    guide: Sequence[str] | None = None,
    assessment: Mapping[str, Any] | None = None,
    transfer: Mapping[str, Any] | None = None,
    soil: Ground | None = None,
    track: Track_ | None = None,
    train: Train_ | None = None,
    irregularity: Mapping[str, Any] | None = None,
    folder: str | PathLike[str] | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Vibration of the ground beside the track during a pass.

    Parameters
    ----------
    speed : float or str
        v [m/s].
    receivers : array-like
        Distances from the centre line of the track [m], ascending.
    passage_time : float or str, optional
        T [s], over which the energy of the pass is averaged; by default train length and twice the farthest receiver over v.
    components : str, optional
        ``"vertical"``, the default, or ``"three"``: along and across the track too, in variables that end in ``_along`` and ``_across``.
    frequencies : slice or mapping, optional
        Bands from the one with the lower to the one with the upper frequency [Hz]; 1 to 80 Hz by default.
    guide : sequence of str, optional
        Standards whose measures are told and whose guide values are drawn; all by default.
    assessment : mapping, optional
        Passes of whole days.
    transfer : mapping, optional
        From the ground into a building, by tables: estimates.
    soil : Soil, str or mapping, optional
        Layered ground: a `Soil`, its table, or a name of the library.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    train : Train, str or mapping, optional
        A `Train`, its table, or a name of the library.
    irregularity : mapping, optional
        Roughness of the rail: a spectrum or a profile, a table ``[irregularity]``.
    folder : path-like, optional
        Where files beside the case are looked for; the working folder by default.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        R.m.s. velocities in third octaves over ``receiver`` and ``band``, measures of standards per receiver, histories.

    Examples
    --------
    >>> import groundwave as gw
    >>> shaken = gw.free_field(soil="lamprea2022_half_space", track="lamprea2022_slab", train="lamprea2022_axle",
    ...                        speed=50.0, receivers=[10.0], frequencies=slice(2, 20))
    >>> shaken.v_rms_total.dims
    ('receiver', 'band')
    """
    keys = {
        "speed": speed, "receivers": receivers, "passage_time": passage_time, "components": components,
        "frequencies": frequencies, "guide": guide, "assessment": assessment, "transfer": transfer,
    }
    return _ask("free_field", keys, progress, soil=soil, track=track, train=train, irregularity=irregularity, folder=folder)


def equivalent_stiffness(
    *,
    beta: Values,
    frequencies: Values,
    soil: Ground | None = None,
    foundation: Springs_ | None = None,
    track: Track_ | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Stiffness of the ground under the track, k_eq(β, ω).

    Parameters
    ----------
    beta : array-like or slice
        β [rad/m].
    frequencies : array-like or slice
        f [Hz].
    soil : Soil, str or mapping, optional
        Layered ground: a `Soil`, its table, or a name of the library.
    foundation : Springs or mapping, optional
        Springs instead of ground: a `Springs` or its table.
    track : Track, str or mapping, optional
        A `Track`, its table, or a name of the library.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        Complex ``k_eq`` [N/m²] over ``omega`` [rad/s] and ``beta``.

    Examples
    --------
    >>> import groundwave as gw
    >>> table = gw.equivalent_stiffness(soil="lamprea2022_layered", track="lamprea2022_slab", beta=[0.2, 1.0], frequencies=[10.0])
    >>> bool((table.k_eq.real > 0).all())
    True
    """
    keys = {
        "beta": beta, "frequencies": frequencies,
    }
    return _ask("equivalent_stiffness", keys, progress, soil=soil, foundation=foundation, track=track)


def surface_compliance(
    *,
    k: Values,
    frequencies: Values,
    soil: Ground | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Displacements of the surface under traction waves, G(k, ω).

    Parameters
    ----------
    k : array-like or slice
        k [rad/m].
    frequencies : array-like or slice
        f [Hz].
    soil : Soil, str or mapping, optional
        Layered ground: a `Soil`, its table, or a name of the library.
    progress : callable, optional
        Called as ``progress(what, done, steps)``.

    Returns
    -------
    xarray.Dataset
        Complex ``u_zz``, ``u_xx``, ``u_xz``, ``u_yy`` [m/Pa] over ``frequency`` and ``k``.

    Examples
    --------
    >>> import groundwave as gw
    >>> table = gw.surface_compliance(soil="lamprea2022_layered", k=[0.1, 1.0], frequencies=[0.0, 20.0])
    >>> table.u_zz.shape
    (2, 2)
    """
    keys = {
        "k": k, "frequencies": frequencies,
    }
    return _ask("surface_compliance", keys, progress, soil=soil)
