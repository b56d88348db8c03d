"""Bindings of groundwave; the package `groundwave` is what to use."""

from collections.abc import Callable, Mapping
from os import PathLike
from typing import Any

__version__: str

class CaseError(ValueError):
    key: str
    line: int | None
    found: str | None
    help: str | None
    faults: list[dict[str, Any]]

class ComputationError(RuntimeError):
    study: str

class Case:
    @staticmethod
    def parse(text: str, name: str, folder: str | PathLike[str], files: Mapping[str, str]) -> Case: ...
    @staticmethod
    def load(path: str | PathLike[str]) -> Case: ...
    @property
    def title(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def files(self) -> dict[str, str]: ...
    @property
    def studies(self) -> list[str]: ...
    @property
    def concerns(self) -> list[tuple[str, str, str]]: ...
    @property
    def chunks(self) -> int | None: ...
    def estimate(self) -> dict[str, float]: ...
    def run(
        self,
        progress: Callable[[str, int, int], object] | None,
        out: str | PathLike[str] | None,
        overwrite: bool,
    ) -> dict[str, Any]: ...
    def sample(
        self,
        out: str | PathLike[str],
        number: int,
        of: int,
        progress: Callable[[str, int, int], object] | None,
    ) -> tuple[int, int]: ...

def gather(
    out: str | PathLike[str],
    report: bool,
    progress: Callable[[str, int, int], object] | None,
) -> list[dict[str, Any]]: ...

def toml(table: dict[str, Any]) -> str: ...
def tables(text: str, folder: str | PathLike[str], files: Mapping[str, str]) -> dict[str, Any]: ...
def library() -> list[tuple[str, str, str, str]]: ...
def show(name: str) -> str: ...
def schema() -> str: ...
