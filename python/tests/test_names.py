"""Names, signatures, documentation: what a user is told is what there is."""

import ast
import inspect
import json
from pathlib import Path

import groundwave as gw
import pytest
from groundwave import _core, studies, tables

SCHEMA = json.loads(_core.schema())
#: Keys of studies that are drawn and nothing else.
DRAWN = {"measured", "spectra", "levels"}
#: Keys that Python, or another argument, has taken.
RENAMED = {"from": "from_"}
PARTS = {"soil", "foundation", "track", "train", "irregularity", "folder", "progress"}


def properties(schema):
    """Keys of a table, whichever kind it is of."""
    if "$ref" in schema:
        return properties(SCHEMA["$defs"][schema["$ref"].split("/")[-1]])
    keys = set(schema.get("properties", {}))
    for one in schema.get("anyOf", []) + schema.get("oneOf", []) + schema.get("allOf", []):
        keys |= properties(one)
    return {key for key in keys if schema.get("properties", {}).get(key) is not False}


@pytest.mark.parametrize("study", studies.__all__)
def test_arguments_are_the_keys_of_the_case_file(study):
    keys = {RENAMED.get(key, key) for key in properties(SCHEMA["properties"][study]) - DRAWN}
    if study == "passage":
        keys = keys - {"track"} | {"span"}
    assert set(inspect.signature(getattr(gw, study)).parameters) - PARTS == keys - PARTS


def test_every_study_is_a_function():
    tables_of_studies = set(SCHEMA["properties"]) - {
        "title", "source", "report", "soil", "foundation", "track", "train", "irregularity",
    }
    # [study] varies a case, and is no question
    assert set(studies.__all__) == tables_of_studies - {"study"}


@pytest.mark.parametrize(
    ("kind", "named"), [("Soil", "soil"), ("Springs", "foundation"), ("Track", "track"), ("Train", "train")]
)
def test_tables_take_their_keys(kind, named):
    keys = properties(SCHEMA["properties"][named]) - {"title", "source", "library"}
    assert set(inspect.signature(getattr(tables, kind)).parameters) - {"source", "self"} == keys


def documented():
    for name in gw.__all__:
        thing = getattr(gw, name)
        if name != "__version__":
            yield name, thing
        if inspect.isclass(thing) and not issubclass(thing, Exception):
            for member, what in vars(thing).items():
                if not member.startswith("_"):
                    yield f"{name}.{member}", what.fget if isinstance(what, property) else what


@pytest.mark.parametrize(("name", "thing"), list(documented()), ids=lambda one: one if isinstance(one, str) else "")
def test_everything_public_is_documented(name, thing):
    text = inspect.getdoc(thing) or ""
    assert text and text[0].isupper()
    if inspect.isfunction(thing):
        asked = [key for key in inspect.signature(thing).parameters if key != "self"]
        for key in asked:
            assert f"\n{key} : " in text, f"{name}: {key} has no line"
    # exceptions are met, not made; a property stands in the example of its class
    if not (inspect.isclass(thing) and issubclass(thing, gw.CaseError | gw.ComputationError)) and inspect.getattr_static(
        getattr(gw, name.split(".")[0]), name.split(".")[-1], None
    ).__class__ is not property:
        assert ">>> " in text, f"{name} has no example"


def test_stubs_are_what_the_module_has():
    stub = ast.parse((Path(_core.__file__).parent / "_core.pyi").read_text(encoding="utf-8"))
    public = {name for name in vars(_core) if not name.startswith("_") or name == "__version__"}
    told = {node.name: node for node in stub.body if isinstance(node, ast.FunctionDef | ast.ClassDef)}
    assert public - {"__version__"} == set(told)
    for name, node in told.items():
        thing = getattr(_core, name)
        if isinstance(node, ast.FunctionDef):
            assert [a.arg for a in node.args.args] == list(inspect.signature(thing).parameters), name
        elif not issubclass(thing, Exception):
            members = {one.name: one for one in node.body if isinstance(one, ast.FunctionDef)}
            assert set(members) == {key for key in vars(thing) if not key.startswith("_")}, name
            for key, one in members.items():
                if callable(getattr(thing, key)):
                    wanted = [a.arg for a in one.args.args]
                    assert wanted == list(inspect.signature(getattr(thing, key)).parameters), key


def test_the_package_says_it_has_types():
    assert (Path(gw.__file__).parent / "py.typed").exists()
