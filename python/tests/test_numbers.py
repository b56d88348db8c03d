"""Numbers that arrive in Python against references made without groundwave, and one way of asking against another."""

import csv
from pathlib import Path

import groundwave as gw
import numpy as np
import pytest
import xarray as xr

ROOT = Path(__file__).parents[2]


def rows(name):
    with open(ROOT / "tests" / "reference" / name, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def material(young, poisson, density, loss_factor, **more):
    return {"young": young, "poisson": poisson, "density": density, "loss_factor": loss_factor, **more}


SOILS = {
    "paper_layered": gw.Soil("lamprea2022_layered"),
    "paper_half_space": gw.Soil(half_space=material(75e6, 0.35, 1800.0, 0.06)),
    "stiff_over_soft": gw.Soil(
        layer=[material(400e6, 0.30, 2000.0, 0.02, thickness=1.5), material(40e6, 0.45, 1700.0, 0.05, thickness=5.0)],
        half_space=material(250e6, 0.40, 1900.0, 0.03),
    ),
}


@pytest.mark.parametrize("name", SOILS)
def test_compliance(name):
    """G(k, ω) against an independent code."""
    asked = [row for row in rows("surface_compliance.csv") if row["profile"] == name and float(row["f_Hz"]) > 0.1]
    k = sorted({float(row["k_per_m"]) for row in asked})
    f = sorted({float(row["f_Hz"]) for row in asked})
    found = SOILS[name].compliance(k=k, f=f)
    for row in asked:
        at = found.sel(frequency=float(row["f_Hz"]), k=float(row["k_per_m"]))
        for component in ["uzz", "uxx", "uxz", "uyy"]:
            wanted = complex(float(row[f"{component}_re"]), float(row[f"{component}_im"]))
            # measured 6e-9, of the digits printed there
            assert abs(at[f"u_{component[1:]}"].item() - wanted) <= 1e-7 * abs(wanted) + 1e-22


def test_equivalent_stiffness():
    """k_eq(β, ω) against an independent code."""
    asked = [row for row in rows("k_eq.csv") if row["profile"] == "paper_layered"]
    assert len(asked) > 50
    for row in asked[::5]:
        found = SOILS["paper_layered"].equivalent_stiffness(
            beta=[float(row["beta_per_m"])],
            f=[float(row["omega_rad_per_s"]) / (2 * np.pi)],
            half_width=float(row["half_width_m"]),
            compatibility=row["compatibility"],
        )
        wanted = complex(float(row["k_eq_re"]), float(row["k_eq_im"]))
        # measured 1e-4, the accuracy k_eq is asked to
        assert abs(found.k_eq.item() / wanted - 1) < 1e-3


def test_a_function_answers_as_a_case():
    """The same question as a function, as tables in a dictionary, and as a text: bit for bit."""
    soil, track, train = gw.Soil("lamprea2022_layered"), gw.Track("lamprea2022_ballasted"), gw.Train("lamprea2022_axle")
    one = gw.critical_speed(soil=soil, track=track, train=train, speeds=slice(100, 160, 10))
    two = gw.Case({
        "soil": soil, "track": track, "train": train, "critical_speed": {"speeds": np.arange(100.0, 161.0, 10.0)},
    }).run()["critical_speed"]
    three = gw.Case(
        'title = "text"\nsoil = "lamprea2022_layered"\ntrack = "lamprea2022_ballasted"\ntrain = "lamprea2022_axle"\n'
        '[critical_speed]\nspeeds = { from = 100.0, to = "576 km/h", step = 10.0 }\n'
    ).run()["critical_speed"]
    for other in [two, three]:
        xr.testing.assert_equal(one, other.to_dataset())
        assert gw.answers(one) == gw.answers(other.to_dataset())
    # the paper: 137 m/s
    assert abs(gw.answers(one)["critical_speed"] - 137) < 1


def test_every_case_is_read_as_the_command_reads_it():
    """Text, files and questions of the cases of the repository; the text of one stands for it elsewhere."""
    paths = sorted((ROOT / "soil_cases").glob("*/case.toml"))
    assert len(paths) > 20
    for path in paths:
        case = gw.Case(path)
        again = gw.Case(case.text + "\n", files=case.files)
        assert (again.title, again.studies) == (case.title, case.studies)
        assert case.text == path.read_text(encoding="utf-8")


def test_units_and_coordinates():
    found = SOILS["paper_layered"].dispersion(f=[10.0, 20.0], modes=1)
    assert found.phase_velocity.attrs["units"] == "m s-1"
    assert found.frequency.attrs == {"units": "Hz", "long_name": found.frequency.attrs["long_name"]}
    assert found.phase_velocity.dims == ("frequency", "mode")
    assert "concerns" in found.attrs and found.attrs["version"] == gw.__version__


def test_netcdf_keeps_everything(tmp_path):
    tree = gw.Case({
        "soil": SOILS["stiff_over_soft"],
        "surface_compliance": {"k": [0.1, 1.0], "frequencies": [5.0]},
        "dispersion": {"frequencies": [10.0, 20.0]},
    }).run()
    gw.to_netcdf(tree, tmp_path / "a.nc")
    back = gw.open_results(tmp_path / "a.nc")
    xr.testing.assert_identical(tree, back)
    assert back["surface_compliance"].u_zz.dtype == complex
    # a file that needs no knowledge of complex numbers
    assert "u_zz_re" in xr.open_dataset(tmp_path / "a.nc", group="surface_compliance", engine="h5netcdf")
