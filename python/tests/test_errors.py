"""What is refused, how it is said, what is doubted."""

import pickle
import warnings

import groundwave as gw
import numpy as np
import pytest

LAYERED = {"soil": "lamprea2022_layered"}


def refused(source, **keys):
    with pytest.raises(gw.CaseError) as caught:
        gw.Case(source, **keys)
    return caught.value


def test_a_fault_has_key_line_found_and_help():
    error = refused('title = "a"\nsoil = "lamprea2022_layered"\n[surface_compliance]\nk = [0.1]\nfrequencis = [1.0]\n')
    assert (error.key, error.line, error.found) == ("surface_compliance.frequencis", 5, "frequencis")
    assert "did you mean `frequencies`" in error.help
    assert str(error).startswith("case:5: surface_compliance.frequencis: unknown key")


def test_all_faults_are_said_at_once():
    error = refused({
        "soil": {"layer": [{"thickness": 2.0, "density": -1500.0, "shear_speed": 100.0, "poisson": 0.3, "damping_ratio": 0.02}]},
        "dispersion": {"frequencies": [0.0, 10.0]},
    })
    assert len(error.faults) >= 2
    assert {"soil.layer[0].density", "dispersion.frequencies[0]"} <= {fault["key"] for fault in error.faults}


@pytest.mark.parametrize(
    ("make", "key", "told"),
    [
        (lambda: gw.Soil("lamprea2022_layerd"), "soil", "lamprea2022_layered"),
        (lambda: gw.Soil(), "soil", "half_space"),
        (lambda: gw.Track("lamprea2022_ballasted", pad={"stifness": 1.0}), "track.pad", "stiffness"),
        (lambda: gw.Train(axles=[]), "train", "axle"),
        (lambda: gw.Springs("wincler", stiffness=1.0), "foundation", "winkler"),
        (lambda: gw.critical_speed(speeds=[50.0], soil="lamprea2022_layered"), "critical_speed", "track"),
        (lambda: gw.surface_compliance(soil="lamprea2022_layered", k=["1 Hz"], frequencies=[1.0]), "surface_compliance.k", "rad/m"),
    ],
)
def test_tables_and_questions_are_refused_at_their_key(make, key, told):
    with pytest.raises(gw.CaseError) as caught:
        make()
    assert caught.value.key.startswith(key)
    assert told in str(caught.value)


def test_what_is_no_table_is_said_by_its_path():
    with pytest.raises(TypeError, match="surface_compliance.k"):
        gw.surface_compliance(soil="lamprea2022_layered", k=object(), frequencies=[1.0])
    with pytest.raises(TypeError, match="unexpected keyword"):
        gw.surface_compliance(soil="lamprea2022_layered", k=[1.0], frequenzies=[1.0])


def test_files():
    assert "no such file" in str(refused("nowhere.toml"))
    error = refused({"title": "a", "soil": "clay", "surface_compliance": {"k": [1.0], "frequencies": [1.0]}}, folder="/nowhere")
    assert "clay.toml" in str(error)
    files = {"clay.toml": '[half_space]\nyoung = 50e6\npoisson = 0.4\ndensity = 1800.0\nloss_factor = 0.05\n'}
    case = gw.Case({"soil": "clay", "surface_compliance": {"k": [1.0], "frequencies": [1.0]}}, files=files)
    assert case.files == files


def test_a_study_without_an_answer():
    """Waves without damping run with the load."""
    soil = gw.Soil(half_space={"shear_speed": 100.0, "poisson": 0.3, "density": 1800.0, "damping_ratio": 0.0})
    with pytest.raises((gw.CaseError, gw.ComputationError), match="damping"):
        gw.critical_speed(soil=soil, track="lamprea2022_slab", train="lamprea2022_axle", speeds=[50.0, 150.0])


def test_errors_travel_between_processes():
    error = refused({**LAYERED, "surface_compliance": {"k": [-1.0], "frequencies": [1.0]}})
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), str(again), again.faults) == (gw.CaseError, str(error), error.faults)


def test_concerns_are_warnings_at_the_line_that_asked():
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        found = gw.critical_speed(
            soil="lamprea2022_layered", track="lamprea2022_ballasted", train="lamprea2022_axle", speeds=[20.0, 40.0]
        )
    doubts = [one for one in heard if issubclass(one.category, gw.Concern)]
    assert doubts and doubts[0].filename == __file__
    assert doubts[0].message.code in found.attrs["concerns"]


def test_values_of_numpy_and_slices():
    def text(**keys):
        return gw.Case({**LAYERED, "surface_compliance": keys}).text

    one = text(k=[0.5, 1.5], frequencies=[1.0, 2.0])
    assert one == text(k=np.array([0.5, 1.5]), frequencies=(np.float64(1.0), np.float32(2.0)))
    assert "from = 1" in text(k=[0.5], frequencies=slice(1, 4, 1))
