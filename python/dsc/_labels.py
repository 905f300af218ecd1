"""Labels that are given by their numbers or their names."""

from __future__ import annotations

import json
import operator
from collections.abc import Mapping, Sequence
from typing import Any, TypeVar, Union

Label = Union[int, str]
"""A label by its number, or by its name, see `Complex.label_names`."""

Value = TypeVar("Value")
ByLabel = Union[Mapping[int, Value], Mapping[str, Value], Mapping[Label, Value]]
"""Values by labels."""


def _integer(value: Any, name: str) -> int:
    try:
        result = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be an integer, not {value!r}") from None
    if not -(2**31) <= result < 2**31:
        raise ValueError(f"{name} does not fit into 32 bits: {result}")
    return result


def _label(label: Label, names: Mapping[int, str]) -> int:
    """Returns the number of a label."""
    if not isinstance(label, str):
        return _integer(label, "a label")
    for number, name in names.items():
        if name == label:
            return number
    known = [repr(name) for name in names.values()]
    more = f" and {len(known) - 5} others" if len(known) > 5 else ""
    raise ValueError(f"no label has the name {label!r}; the names are: {', '.join(known[:5]) or 'none'}{more}")


def _by_label(values: ByLabel[Value], names: Mapping[int, str]) -> dict[int, Value]:
    """Returns values by the numbers of labels."""
    result = {_label(label, names): value for label, value in values.items()}
    if len(result) < len(values):
        raise ValueError("a label occurs twice, by its number and by its name")
    return result


def _pairs(pairs: Sequence[Any], names: Mapping[int, str]) -> list[Any]:
    """Returns pairs of labels without names. Other values are not changed."""

    def number(label: Any) -> Any:
        return _label(label, names) if isinstance(label, str) else label

    return [tuple(map(number, pair)) if isinstance(pair, (list, tuple)) else pair for pair in pairs]


def _names_of(metadata: bytes) -> dict[int, str]:
    """Returns the names of labels in the metadata of a checkpoint."""
    try:
        entries = json.loads(metadata.split(b"\n")[0]).get("labels", [])
        return {int(entry["label"]): str(entry["name"]) for entry in entries}
    except (ValueError, AttributeError, KeyError, TypeError):  # metadata of another program
        return {}
