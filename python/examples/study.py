"""Soil is never known: which critical speeds does an uncertain layer leave?"""

# %% what varies, and how
import tempfile
from pathlib import Path

import groundwave as gw

case = gw.Case({
    "title": "An uncertain layer",
    "soil": {
        "layer": [{"thickness": 2.0, "shear_speed": 120.0, "poisson": 0.35, "density": 1500.0, "damping_ratio": 0.03}],
        "half_space": {"shear_speed": 200.0, "poisson": 0.35, "density": 1800.0, "damping_ratio": 0.03},
    },
    "track": "lamprea2022_ballasted",
    "train": "lamprea2022_axle",
    "critical_speed": {"speeds": slice(60, 260, 20)},
    "study": {
        "samples": 50,
        "seed": 1,
        "method": "latin-hypercube",
        "derivatives": False,
        "vary": [{"key": "soil.layer.0.shear_speed", "kind": "lognormal", "median": 120.0, "sigma_ln": 0.15}],
    },
})

# %% samples on the threads of this machine; client=distributed.Client(...) for a cluster
with tempfile.TemporaryDirectory() as folder:
    tree = gw.study(case, Path(folder) / "study")
print(tree["study"])
speeds = tree["study"][next(name for name in tree["study"].data_vars if name.endswith("critical_speed"))]
print(3.6 * speeds.quantile([0.05, 0.5, 0.95]).to_series().rename("critical speed [km/h]"))
assert 100 < float(speeds.median()) < 170
