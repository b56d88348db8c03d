"""One case, several questions, one file: the same case file runs with the command and in Python."""

# %%
import tempfile
from pathlib import Path

import groundwave as gw

case = gw.Case({
    "title": "Soft clay under a slab track",
    "soil": "lamprea2022_layered",
    "track": "lamprea2022_slab",
    "train": "lamprea2022_axle",
    "critical_speed": {"speeds": slice(40, 200, 10)},
    "dispersion": {"frequencies": slice(5, 50, 5)},
})
tree = case.run(progress=lambda what, done, steps: print(f"{what}: {done} of {steps}"))
print(tree)

# %% a file that everyone reads, and the case for the command's report
with tempfile.TemporaryDirectory() as folder:
    gw.to_netcdf(tree, Path(folder) / "clay.nc")
    assert gw.open_results(Path(folder) / "clay.nc").identical(tree)
    (Path(folder) / "clay.toml").write_text(case.text, encoding="utf-8")
    assert gw.Case(Path(folder) / "clay.toml").run()["dispersion"].identical(tree["dispersion"])
