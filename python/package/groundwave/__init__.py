"""groundwave: moving trains on layered ground.

How fast may a train go before ground and track resonate, how much does the track move, what does the ground around it do, how much
vibration reaches a house. Every question is a function (`critical_speed`, `free_field`, …) that takes a `Soil`, a `Track`, a `Train`
and the keys it has in a case file; a `Case` answers several at once. Answers are xarray objects with units and coordinates.

Numbers are SI, or texts with a unit: ``"250 km/h"``.

Examples
--------
>>> import groundwave as gw
>>> curve = gw.critical_speed(soil="lamprea2022_half_space", track="lamprea2022_slab", train="lamprea2022_axle",
...                           speeds=slice("300 km/h", "600 km/h", "30 km/h"))
>>> f'{3.6 * gw.answers(curve)["critical_speed"]:.0f} km/h'
'413 km/h'
"""

from ._core import CaseError, ComputationError, __version__
from .case import Case
from .catalogue import library, show
from .ensemble import study
from .results import Concern, answers, open_results, to_netcdf
from .studies import (
    contour,
    critical_speed,
    decay_rate,
    dispersion,
    equivalent_stiffness,
    free_field,
    ground_at_depth,
    passage,
    receptance,
    surface_compliance,
    track_response,
    transition,
)
from .tables import Soil, Springs, Track, Train

__all__ = [
    "Case",
    "CaseError",
    "ComputationError",
    "Concern",
    "Soil",
    "Springs",
    "Track",
    "Train",
    "__version__",
    "answers",
    "contour",
    "critical_speed",
    "decay_rate",
    "dispersion",
    "equivalent_stiffness",
    "free_field",
    "ground_at_depth",
    "library",
    "open_results",
    "passage",
    "receptance",
    "show",
    "study",
    "surface_compliance",
    "to_netcdf",
    "track_response",
    "transition",
]
