"""Values of a signature database by their key paths."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from smat._core import SignatureDatabase, Spectrum


def value_at(database: SignatureDatabase, path: str) -> Any:
    """The value at 'materials.1.emissivity'; KeyError for a path that leads nowhere."""
    value: Any = database.to_dict()
    for key in path.split("."):
        if not isinstance(value, dict) or key not in value:
            raise KeyError(path)
        value = value[key]
    return value


def replaced(database: SignatureDatabase, values: Mapping[str, Any]) -> SignatureDatabase:
    """The database with other values by key path."""
    tree = database.to_dict()
    for path, value in values.items():
        *folders, key = path.split(".")
        place: Any = tree
        for folder in folders:
            if not isinstance(place, dict) or folder not in place:
                raise KeyError(path)
            place = place[folder]
        if not isinstance(place, dict):
            raise KeyError(path)
        place[key] = _json_of(value)
    return SignatureDatabase(json.dumps(tree), "replaced values")


def _json_of(value: Any) -> Any:
    if isinstance(value, Spectrum):
        if value.is_constant:
            return float(value.values[0])
        return [list(node) for node in zip(value.wavelengths_um.tolist(), value.values.tolist())]
    if hasattr(value, "tolist"):
        return value.tolist()
    return value
