"""Tables for pandas and xarray, which are imported only here and only when asked for."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from smat._core import Table


def to_pandas(table: Table) -> Any:
    """A pandas.DataFrame of copies of the columns."""
    pandas: Any = importlib.import_module("pandas")

    frame = pandas.DataFrame({key: np.array(column) for key, column in table.items()})
    frame.attrs["units"] = dict(table.units)
    frame.attrs["provenance"] = [list(entry) for entry in table.provenance]
    return frame


def to_xarray(table: Table) -> Any:
    """An xarray.Dataset; a complete grid of azimuths and elevations has two dimensions."""
    xarray: Any = importlib.import_module("xarray")

    keys = table.keys()
    axes = [keys[0]]
    if axes[0] in ("azimuth", "elevation") and {"azimuth", "elevation"} <= set(keys):
        grid = np.unique(table["elevation"]).size * np.unique(table["azimuth"]).size
        directions = np.unique(np.stack([table["elevation"], table["azimuth"]]), axis=1).shape[1]
        if 0 < table.rows == grid == directions:
            axes = ["elevation", "azimuth"]
    coordinates = [np.unique(table[axis]) if len(axes) > 1 else np.array(table[axis]) for axis in axes]
    places = [
        np.searchsorted(values, table[axis]) if len(axes) > 1 else np.arange(table.rows)
        for axis, values in zip(axes, coordinates)
    ]
    data = {}
    for key, column in table.items():
        if key in axes:
            continue
        values = np.full([coordinate.size for coordinate in coordinates], np.nan)
        values[tuple(places)] = column
        data[key] = (axes, values, {"units": table.units[key]})
    return xarray.Dataset(
        data,
        {
            axis: (axis, values, {"units": table.units[axis]})
            for axis, values in zip(axes, coordinates)
        },
        {f"{number}: {key}": value for number, (key, value) in enumerate(table.provenance)},
    )
