"""Every script of python/examples runs; every study has one."""

import runpy
import warnings
from pathlib import Path

import groundwave as gw
import pytest
from groundwave import studies

SCRIPTS = sorted((Path(__file__).parents[1] / "examples").glob("*.py"))


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_example(path):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", gw.Concern)
        runpy.run_path(str(path), run_name="__main__")


def test_every_study_has_one():
    assert set(studies.__all__) <= {path.stem for path in SCRIPTS}
