"""Documents as dictionaries and as JSON."""

import json
import math
import re
from collections.abc import Mapping
from typing import Any

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


def replaced(document: dict[str, Any], path: str, value: Any) -> None:
    """Puts `value` at a path such as `noise.sigma` or `anchors[2][0]`, in place.

    Raises:
        Error: where the path leads nowhere.

    """
    found = re.findall(r"\[(\d+)\]|([^.\[\]]+)", path)
    keys = [int(index) if index else name for index, name in found]
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
