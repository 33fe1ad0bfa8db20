"""Documents as dictionaries and as JSON."""

import copy
import json
import math
import re
from abc import ABC, abstractmethod
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Self

import numpy as np

from ._core import Error

Document = Mapping[str, Any]


def to_text(document: Document | str) -> str:
    """The JSON of a document, in which arrays stand for lists.

    Raises:
        Error: with the path of a number that is not finite, or of something that JSON cannot hold.

    """
    return document if isinstance(document, str) else json.dumps(plain(document))


def plain(value: Any, path: str = "") -> Any:
    """Lists, dictionaries, numbers and texts in place of arrays, tuples and mappings."""
    if isinstance(value, Mapping):
        return {str(key): plain(entry, f"{path}.{key}".lstrip(".")) for key, entry in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return plain(value.tolist(), path)
    if isinstance(value, list | tuple):
        return [plain(entry, f"{path}[{i}]") for i, entry in enumerate(value)]
    if isinstance(value, float) and not math.isfinite(value):
        raise Error(f"{path} is {value}, allowed: a finite number")
    if value is None or isinstance(value, bool | int | float | str):
        return value
    raise Error(f"{path} is a {type(value).__name__}, allowed: numbers, texts, lists and dictionaries")


def _keys(path: str) -> list[Any]:
    """The names and numbers of a path such as `anchors[2][0]`."""
    parts = re.findall(r"\[(\d+)\]|([^.\[\]]+)", path)
    return [int(index) if index else name for index, name in parts]


def found(document: dict[str, Any], path: str, missing: Any = None) -> Any:
    """The value at a path such as `noise.sigma`; `missing` where there is nothing."""
    at: Any = document
    for key in _keys(path):
        try:
            at = at[key]
        except (KeyError, IndexError, TypeError):
            return missing
    return at


def replaced(document: dict[str, Any], path: str, value: Any) -> None:
    """Puts `value` at a path such as `noise.sigma` or `anchors[2][0]`, in place.

    Raises:
        Error: where the path leads nowhere.

    """
    keys = _keys(path)
    at: Any = document
    try:
        for key in keys[:-1]:
            at = at[key]
        if isinstance(at, list):
            at[keys[-1]] = value
        else:
            at.update({keys[-1]: value})
    except (AttributeError, KeyError, IndexError, TypeError):
        raise Error(f"the document has nothing at {path}") from None


class Written(ABC):
    """A document that the crate reads from JSON and writes; immutable."""

    @abstractmethod
    def __init__(self, document: Document | str) -> None: ...

    @abstractmethod
    def to_json(self) -> str:
        """The whole document as JSON; every number comes back as the same bits."""

    @classmethod
    def read(cls, path: str | Path) -> Self:
        """From a file."""
        return cls(Path(path).read_text(encoding="utf-8"))

    def to_dict(self) -> dict[str, Any]:
        """As a dictionary, a copy."""
        document: dict[str, Any] = json.loads(self.to_json())
        return document

    def replace(self, changes: Mapping[str, Any] | None = None, /, **more: Any) -> Self:
        """With other values, by the paths that error messages use, such as `noise.sigma` or `anchors[0]`."""
        document = copy.deepcopy(self.to_dict())
        for path, value in {**(changes or {}), **more}.items():
            replaced(document, path, value)
        return type(self)(document)

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and isinstance(other, Written) and self.to_json() == other.to_json()

    def __hash__(self) -> int:
        return hash(self.to_json())

    def __reduce__(self) -> tuple[type[Self], tuple[str]]:
        return type(self), (self.to_json(),)
