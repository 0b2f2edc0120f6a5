"""Points of a plume from a .vtu file, or any other that meshio reads, as `smat-batch plume` takes them.

    python plume_points.py flow.vtu points.csv --axes x,y,z --pressure-unit Pa T=Temperature p=Pressure CO2=X_CO2

Columns that are not named are those arrays of the file that are called T, p, CO2, H2O, CO, CH4, O2 and soot. Arrays of
points stand at points, those of cells at the middles of cells. What meshio cannot read, such as polyhedra and LZ4, is
read with the package vtk where that is installed. Without files it makes a small one of its own.
"""

import argparse
import pathlib

import meshio  # type: ignore[import-not-found,import-untyped,unused-ignore]
import numpy as np
from numpy.typing import NDArray

HEADS = {"T": "T [K]", "p": "p [atm]", "soot": "soot [ppmv]"}
COLUMNS = ["T", "p", "CO2", "H2O", "CO", "CH4", "O2", "soot"]
MASSES = {"CO2": 44.01, "H2O": 18.015, "CO": 28.01, "CH4": 16.043, "O2": 31.998, "rest": 28.014}  # g/mol
PASCALS = {"Pa": 101325.0, "hPa": 1013.25, "kPa": 101.325, "bar": 1.01325, "atm": 1.0}  # of an atmosphere


def write_small(file: pathlib.Path) -> None:
    """A hot jet along x in a box of 11 x 9 x 9 points."""
    axes = np.linspace(0, 2, 11), np.linspace(-0.6, 0.6, 9), np.linspace(-0.6, 0.6, 9)
    x, y, z = (one.ravel() for one in np.meshgrid(*axes, indexing="ij"))
    part = np.exp(-(y**2 + z**2) / (0.15 + 0.1 * x) ** 2) / (1 + x)
    numbers = np.arange(x.size).reshape(11, 9, 9)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = np.stack([numbers[i : i + 10, j : j + 8, k : k + 8].ravel() for i, j, k in corners], axis=1)
    arrays = {"T": 288 + 600 * part, "p": np.full(x.size, 101325.0), "CO2": 0.04 * part, "H2O": 0.04 * part}
    meshio.Mesh(np.stack([x, y, z], axis=1), [("hexahedron", cells)], point_data=arrays).write(file)


Table = tuple[NDArray[np.float64], dict[str, NDArray[np.float64]]]  # places by point and axis, m, and arrays


def by_meshio(file: pathlib.Path) -> tuple[Table, Table]:
    """Of points and of the middles of cells."""
    mesh = meshio.read(file)
    middles = [mesh.points[cells.data].mean(axis=1) for cells in mesh.cells]
    of_cells = {name: np.concatenate(values) for name, values in mesh.cell_data.items()}
    return (mesh.points, mesh.point_data), (np.concatenate(middles) if middles else np.empty((0, 3)), of_cells)


def by_vtk(file: pathlib.Path) -> tuple[Table, Table]:
    """The same with the package vtk."""
    from vtkmodules.util.numpy_support import vtk_to_numpy  # type: ignore
    from vtkmodules.vtkFiltersCore import vtkCellCenters  # type: ignore
    from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader  # type: ignore

    reader = vtkXMLGenericDataObjectReader()
    reader.SetFileName(str(file))
    reader.Update()
    grid = reader.GetOutput()
    if grid is None or not hasattr(grid, "GetPoints") or grid.GetPoints() is None:
        raise ValueError("vtk finds no points")
    centres = vtkCellCenters()
    centres.SetInputData(grid)
    centres.Update()

    def table(points: object, data: object) -> Table:
        arrays = {data.GetArrayName(i): data.GetArray(i) for i in range(data.GetNumberOfArrays())}  # type: ignore
        return vtk_to_numpy(points.GetData()), {  # type: ignore
            name: vtk_to_numpy(array) for name, array in arrays.items() if array is not None
        }

    return table(grid.GetPoints(), grid.GetPointData()), table(centres.GetOutput().GetPoints(), grid.GetCellData())


def load(file: pathlib.Path) -> tuple[Table, Table]:
    if not file.is_file():
        raise SystemExit(f"{file}: no such file")
    try:
        return by_meshio(file)
    except (Exception, SystemExit) as refused:  # of many kinds, asserts among them
        why = f"{type(refused).__name__} {refused}".strip()
    try:
        return by_vtk(file)
    except ImportError:
        raise SystemExit(
            f"{file}: meshio cannot read it ({why}); write it with cells that are no polyhedra and without LZ4, "
            "or install the package vtk, which reads it"
        ) from None
    except Exception as refused:
        raise SystemExit(f"{file}: neither meshio ({why}) nor vtk ({refused}) can read it") from None


def read(file: pathlib.Path, names: dict[str, str]) -> Table:
    """Places by point and axis, m, and the columns that the file has."""
    of_points, of_cells = load(file)
    if names["T"] in of_points[1]:
        places, arrays = of_points
    elif names["T"] in of_cells[1]:
        places, arrays = of_cells
    else:
        raise SystemExit(f"{file}: no array {names['T']}; there are {[*of_points[1], *of_cells[1]]}")
    found = {column: np.asarray(arrays[name], float) for column, name in names.items() if name in arrays}
    return np.asarray(places, float), found


def mole_fractions(columns: dict[str, NDArray[np.float64]]) -> None:
    """In place of mass fractions; what is left is nitrogen."""
    gases = [column for column in columns if column in MASSES]
    rest = 1 - sum(columns[gas] for gas in gases)
    moles = {gas: columns[gas] / MASSES[gas] for gas in gases}
    total = rest / MASSES["rest"] + sum(moles.values())
    columns.update({gas: moles[gas] / total for gas in gases})


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    options.add_argument("flow", nargs="?", type=pathlib.Path, default=pathlib.Path("flow.vtu"))
    options.add_argument("points", nargs="?", type=pathlib.Path, default=pathlib.Path("points.csv"))
    options.add_argument("names", nargs="*", metavar="COLUMN=ARRAY")
    options.add_argument("--axes", default="x,y,z", help="those of the file downstream, to starboard and up, as -z,x,y")
    options.add_argument("--pressure-unit", choices=PASCALS, default="Pa")
    options.add_argument("--mass", action="store_true", help="fractions of the file are of the mass")
    options.add_argument("--quick", action="store_true", help="as the tests run it")
    asked = options.parse_args()
    if not asked.flow.exists() and asked.flow == pathlib.Path("flow.vtu"):
        write_small(asked.flow)
    names = {column: column for column in COLUMNS} | dict(name.split("=", 1) for name in asked.names)
    places, columns = read(asked.flow, names)
    if asked.mass:
        mole_fractions(columns)
    if "p" in columns:
        columns["p"] = columns["p"] / PASCALS[asked.pressure_unit]
    for axis in asked.axes.split(","):
        if axis.lstrip("-") not in ("x", "y", "z"):
            raise SystemExit(f"--axes {asked.axes}: three of x, y, z, -x, -y, -z")
    turned = [
        (-1 if axis[0] == "-" else 1) * places[:, "xyz".index(axis[-1])] + 0.0 for axis in asked.axes.split(",")
    ]
    order = [column for column in COLUMNS if column in columns]
    head = ["x [m]", "y [m]", "z [m]", *(HEADS.get(column, column) for column in order)]
    table = np.column_stack([*turned, *(columns[column] for column in order)])
    np.savetxt(asked.points, table, fmt="%.9g", delimiter=",", header=",".join(head), comments="")
    print(f"{len(table)} points with {', '.join(order)} in {asked.points}")


if __name__ == "__main__":
    main()
