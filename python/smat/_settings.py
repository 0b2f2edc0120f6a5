"""Values of settings: from Python to the canonical texts of files and back."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, Union

from smat._core import Band, SettingInfo, find_setting, is_no_atmosphere, settings
from smat.errors import Diagnostic, InputError

#: What a setting may be given as: lists for lists of numbers, bands and files, pairs of um for bands.
SettingValue = Union[
    bool, int, float, str, "os.PathLike[str]", Band, tuple[float, float], Sequence[Any]
]
#: What a setting is read as.
SettingResult = Union[
    bool, int, float, str, list[float], list[tuple[float, float]], list[str]
]


def _path(value: Any) -> str:
    """A path is relative to where the caller stands, as an option of the command line is."""
    text = os.fspath(value)
    return text if text in ("", "none") or is_no_atmosphere(text) else os.path.abspath(text)


def _number(value: Any) -> str:
    return value if isinstance(value, str) else repr(value.item() if hasattr(value, "item") else value)


def _band(value: Any) -> str:
    if isinstance(value, Band):
        if not value.is_top_hat:
            raise InputError(
                [Diagnostic("sensor.band", "", value.name, "a band of two wavelengths; a response is the setting sensor.response")]
            )
        value = value.range_um
    if isinstance(value, str):
        return value
    shortest, longest = value
    return f"{_number(shortest)}-{_number(longest)}"


def _is_pair(value: Any) -> bool:
    return isinstance(value, tuple) and len(value) == 2 and not any(
        isinstance(item, (str, tuple, list, Band)) for item in value
    )


def text_of(info: SettingInfo, value: Any) -> str:
    """The text of a value as a value of that setting; the library checks it."""
    if info.kind == "path":
        return _path(value)
    if info.kind == "path list":
        items = value.split(";") if isinstance(value, str) else value
        if isinstance(items, os.PathLike):
            items = [items]
        return ";".join(_path(item) for item in items) or "none"
    if isinstance(value, str):
        return value
    if info.kind == "band":
        bands = [value] if isinstance(value, Band) or _is_pair(value) else value
        return ",".join(_band(item) for item in bands)
    if info.kind == "boolean":
        return "true" if value else "false"
    if info.kind == "real list" and not isinstance(value, (int, float)):
        return ",".join(_number(item) for item in value)
    if isinstance(value, bool):
        return "on" if value and "on" in info.choices else "off" if "off" in info.choices else str(value)
    return _number(value)


def value_of(info: SettingInfo, text: str) -> SettingResult:
    """The value of a canonical text."""
    if info.kind == "boolean":
        return text == "true"
    if info.kind == "integer":
        return int(text)
    if info.kind == "real":
        return float(text)
    if info.kind == "choice or real":
        return text if text in info.choices else float(text)
    if info.kind == "real list":
        return text if text in info.choices else [float(item) for item in text.split(",")]
    if info.kind == "band":
        bands = [item.split("-") for item in text.split(",")]
        return [(float(shortest), float(longest)) for shortest, longest in bands]
    if info.kind == "path list":
        return [] if text in ("", "none") else text.split(";")
    return text


def texts(values: Mapping[str, Any]) -> dict[str, str]:
    """Texts by key of values by key; InputError for a key that does not exist."""
    return {
        key if key.startswith("models.") else find_setting(key).key: _number(value)
        if key.startswith("models.")
        else text_of(find_setting(key), value)
        for key, value in values.items()
    }


def texts_of_options(kind: str, options: Mapping[str, Any]) -> dict[str, str]:
    """The same of keyword arguments, which are the options of the command line."""
    by_option = {info.option: info for info in settings() if info.concerns(kind)}
    found = {}
    for keyword, value in options.items():
        option = keyword.rstrip("_")
        if option not in by_option:
            raise TypeError(
                f"{kind} has no option {keyword!r}; smat.settings() lists those there are, "
                "and settings={'section.name': value} takes them by key"
            )
        info = by_option[option]
        found[info.key] = text_of(info, value)
    return found
