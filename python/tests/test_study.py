"""Samples in threads, in two halves, and on a Dask cluster that loses a worker: the same numbers, bit for bit."""

import os
import signal
from pathlib import Path

import groundwave as gw
import pytest
import xarray as xr

pytestmark = pytest.mark.filterwarnings("ignore::groundwave.Concern")

CASE = {
    "title": "An uncertain layer",
    "soil": {
        "layer": [{"thickness": 2.0, "shear_speed": 120.0, "poisson": 0.35, "density": 1500.0, "damping_ratio": 0.03}],
        "half_space": {"shear_speed": 200.0, "poisson": 0.35, "density": 1800.0, "damping_ratio": 0.03},
    },
    "track": "lamprea2022_ballasted",
    "train": "lamprea2022_axle",
    "critical_speed": {"speeds": slice(60, 200, 20)},
    "study": {
        "samples": 100,
        "seed": 7,
        "method": "latin-hypercube",
        "derivatives": False,
        "vary": [
            {"key": "soil.layer.0.shear_speed", "kind": "lognormal", "median": 120.0, "sigma_ln": 0.15},
            {"key": "soil.layer.0.thickness", "kind": "triangular", "from": 1.5, "mode": 2.0, "to": 3.0},
        ],
    },
}


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    return gw.study(gw.Case(CASE), tmp_path_factory.mktemp("whole") / "study")


def test_samples_are_single_runs(whole):
    """What a sample says is what its case says when it runs alone."""
    assert whole["study"].sizes["sample"] == 100
    curves = whole["critical_speed"]
    assert curves.max_down.dims == ("sample", "speed") and curves.max_down.attrs["units"] == "m"
    names = [name for name in whole["study"].data_vars if "shear_speed" in name or "thickness" in name]
    speed, thickness = (next(name for name in names if key in name) for key in ["shear_speed", "thickness"])
    for i in [0, 41, 99]:
        soil = {"layer": [dict(CASE["soil"]["layer"][0])], "half_space": CASE["soil"]["half_space"]}
        soil["layer"][0]["shear_speed"] = whole["study"][speed][i].item()
        soil["layer"][0]["thickness"] = whole["study"][thickness][i].item()
        alone = gw.critical_speed(soil=soil, track=CASE["track"], train=CASE["train"], speeds=slice(60, 200, 20))
        assert (alone.max_down.values == curves.max_down[i].values).all()


def test_shards_and_the_whole(whole, tmp_path):
    """Two processes of a cluster's array job, then gathered: nothing is run twice."""
    case = gw.Case(CASE)
    done = [case._core.sample(str(tmp_path), number, 3, None) for number in [1, 2]]
    with pytest.raises(ValueError, match="not complete"):
        gw._core.gather(str(tmp_path), False, None)
    assert sum(rows for rows, _ in done) < 101
    tree = gw.study(case, tmp_path)
    xr.testing.assert_identical(tree, whole)


def test_a_worker_that_is_killed_loses_nothing(whole, tmp_path):
    distributed = pytest.importorskip("distributed")
    # small chunks of work are over before anyone is killed: a finer curve
    case = gw.Case({**CASE, "critical_speed": {"speeds": slice(60, 200, 4)}})
    alone = gw.study(case, tmp_path / "alone")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        client.wait_for_workers(2, timeout=60)
        killed = []

        def kill(what, done, steps):
            if not killed:
                killed.append(next(iter(client.run(os.getpid).values())))
                os.kill(killed[0], signal.SIGKILL)

        tree = gw.study(case, tmp_path / "cluster", client=client, progress=kill)
        assert killed
    xr.testing.assert_identical(tree, alone)
    assert not [name for name in os.listdir(tmp_path / "cluster" / "chunks") if not name.endswith(".json")]


def test_what_is_refused(tmp_path):
    without = {key: value for key, value in CASE.items() if key != "study"}
    with pytest.raises(ValueError, match="no \\[study\\]"):
        gw.study(gw.Case(without), tmp_path / "a")
    gw.study(gw.Case(CASE), tmp_path / "b")
    other = gw.Case({**CASE, "study": {**CASE["study"], "seed": 8}})
    with pytest.raises(ValueError, match="another study"):
        gw.study(other, tmp_path / "b")
    (tmp_path / "c").mkdir()
    (tmp_path / "c" / "letters.txt").write_text("mine")
    with pytest.raises(OSError, match="letters.txt"):
        gw.study(gw.Case(CASE), tmp_path / "c")
    with pytest.raises(gw.CaseError, match="soil.layer.7"):
        gw.Case({**CASE, "study": {**CASE["study"], "vary": [{"key": "soil.layer.7.density", "kind": "uniform", "from": 1.0, "to": 2.0}]}})


def test_the_report(tmp_path):
    gw.study(gw.Case(CASE), tmp_path / "s", report=True)
    files = {path.name for path in (tmp_path / "s" / "gathered").iterdir()}
    assert {"report.html", "study.h5"} <= files
    tree = gw.Case(CASE).run(out=tmp_path / "run")
    assert {"report.html", "results.h5", "summary.json"} <= {path.name for path in Path(tmp_path / "run").iterdir()}
    back = gw.open_results(tmp_path / "run" / "results.h5")
    # the file has no `answers` in words
    xr.testing.assert_equal(back["critical_speed"].to_dataset(), tree["critical_speed"].to_dataset())
    assert gw.Case(tmp_path / "run" / "results.h5").text == gw.Case(CASE).text
    with pytest.raises(FileExistsError):
        gw.Case(CASE).run(out=tmp_path / "run")
    gw.Case(CASE).run(out=tmp_path / "run", overwrite=True)
