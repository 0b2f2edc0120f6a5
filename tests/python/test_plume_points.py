"""Every form of data that .vtu files have gives the same points."""

import base64
import itertools
import pathlib
import struct
import subprocess
import sys
import zlib

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("meshio")

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "python" / "examples" / "plume_points.py"
# Two tetrahedra on a face.
POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], float)
CELLS = np.array([[0, 1, 2, 3], [1, 2, 3, 4]], np.int64)
NAMES = {np.dtype(float): "Float64", np.dtype(np.float32): "Float32", np.dtype(np.int64): "Int64", np.dtype(np.uint8): "UInt8"}


def arrays(of_cells):
    """Name, values and components of each; float32 and float64 with values that both have."""
    count = len(CELLS) if of_cells else len(POINTS)
    data = [
        ("T", np.arange(count, dtype=np.float32) * 125 + 300, 1),
        ("p", np.full(count, 101325.0), 1),
        ("CO2", np.arange(count) / 64, 1),
        ("U", np.arange(3.0 * count), 3),
    ]
    mesh = [
        ("Points", POINTS.ravel(), 3),
        ("connectivity", CELLS.ravel(), 1),
        ("offsets", np.array([4, 8], np.int64), 1),
        ("types", np.array([10, 10], np.uint8), 1),
    ]
    return data, mesh


def block(values, order, header, compressed):
    """The bytes of an array and of what stands before it, by the file format of VTK."""
    raw = values.astype(values.dtype.newbyteorder(order)).tobytes()
    if not compressed:
        return struct.pack(order + header, len(raw)), raw
    size = 32  # of a block, so that there are several and a rest
    pieces = [raw[at : at + size] for at in range(0, len(raw), size)]
    packed = [zlib.compress(piece) for piece in pieces]
    rest = len(raw) % size
    head = [len(pieces), size, rest, *(len(piece) for piece in packed)]
    return struct.pack(order + header * len(head), *head), b"".join(packed)


def vtu(form, of_cells=False, order="<", header="Q", compressed=False, compressor="vtkZLibDataCompressor"):
    """The file as bytes. `form`: ascii, binary, raw or base64 (these two appended)."""
    appended = b""

    def element(name, values, components):
        nonlocal appended
        head = f'<DataArray type="{NAMES[values.dtype]}" Name="{name}" NumberOfComponents="{components}"'
        if form == "ascii":
            return f'{head} format="ascii">{" ".join(map(repr, values.tolist()))}</DataArray>'
        before, data = block(values, order, header, compressed)
        if form == "raw":
            text, where = before + data, len(appended)
        else:
            # Head and data are encoded apart where they are compressed.
            whole = [before, data] if compressed else [before + data]
            text, where = b"".join(base64.b64encode(part) for part in whole), len(appended)
        if form == "binary":
            return f'{head} format="binary">{text.decode()}</DataArray>'
        appended += text
        return f'{head} format="appended" offset="{where}"/>'

    data, mesh = arrays(of_cells)
    fields = "".join(element(*one) for one in data)
    (points, *cells) = [element(*one) for one in mesh]
    which = "CellData" if of_cells else "PointData"
    begin = (
        f'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" '
        f'byte_order="{"LittleEndian" if order == "<" else "BigEndian"}" header_type="{"UInt64" if header == "Q" else "UInt32"}"'
        + (f' compressor="{compressor}"' if compressed else "")
        + f'>\n<UnstructuredGrid><Piece NumberOfPoints="{len(POINTS)}" NumberOfCells="{len(CELLS)}">\n'
        f"<{which}>{fields}</{which}>\n<Points>{points}</Points>\n<Cells>{''.join(cells)}</Cells>\n"
        "</Piece></UnstructuredGrid>\n"
    )
    if form in ("raw", "base64"):
        begin += f'<AppendedData encoding="{form}">\n_'
        return begin.encode() + appended + b"\n</AppendedData>\n</VTKFile>\n"
    return (begin + "</VTKFile>\n").encode()


def points_of(folder, content):
    (folder / "flow.vtu").write_bytes(content)
    done = subprocess.run(
        [sys.executable, EXAMPLE, "flow.vtu", "points.csv"], cwd=folder, capture_output=True, text=True, timeout=120
    )
    return done, (folder / "points.csv").read_text() if done.returncode == 0 else ""


@pytest.mark.parametrize("of_cells", [False, True], ids=["points", "cells"])
def test_ascii_gives_the_arrays_themselves(tmp_path, of_cells):
    done, text = points_of(tmp_path, vtu("ascii", of_cells))
    assert done.returncode == 0, done.stderr
    head, *rows = text.splitlines()
    assert head == "x [m],y [m],z [m],T [K],p [atm],CO2"
    table = np.array([[float(cell) for cell in row.split(",")] for row in rows])
    places = POINTS[CELLS].mean(axis=1) if of_cells else POINTS
    (_, kelvin, _), _, (_, fraction, _), _ = arrays(of_cells)[0]
    assert np.allclose(table, np.column_stack([places, kelvin, np.ones(len(places)), fraction]), rtol=1e-8)


FORMS = [
    (form, order, header, compressed)
    for form, order, header, compressed in itertools.product(("binary", "raw", "base64"), "<>", "QI", (False, True))
]


@pytest.fixture(scope="module")
def of_ascii(tmp_path_factory):
    return {of_cells: points_of(tmp_path_factory.mktemp("ascii"), vtu("ascii", of_cells))[1] for of_cells in (False, True)}


@pytest.mark.parametrize("of_cells", [False, True], ids=["points", "cells"])
@pytest.mark.parametrize("form,order,header,compressed", FORMS)
def test_every_other_form_gives_the_same(tmp_path, of_ascii, of_cells, form, order, header, compressed):
    done, text = points_of(tmp_path, vtu(form, of_cells, order, header, compressed))
    assert done.returncode == 0, done.stderr
    assert text == of_ascii[of_cells] != ""


def has_vtk():
    try:
        import vtkmodules  # noqa: F401
    except ImportError:
        return False
    return True


@pytest.mark.skipif(has_vtk(), reason="the package vtk reads it")
@pytest.mark.parametrize("form", ["binary", "raw", "base64"])
def test_what_cannot_be_read_is_told_with_the_way_out(tmp_path, form):
    done, _ = points_of(tmp_path, vtu(form, compressed=True, compressor="vtkLZ4DataCompressor"))
    assert done.returncode == 1
    last = done.stderr.strip().splitlines()[-1]
    assert last.startswith("flow.vtu: meshio cannot read it")
    assert "without LZ4, or install the package vtk" in last


def test_a_file_that_is_not_there_is_named(tmp_path):
    done = subprocess.run(
        [sys.executable, EXAMPLE, "none.vtu", "points.csv"], cwd=tmp_path, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 1
    assert done.stderr.strip() == "none.vtu: no such file"
