#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "python/src/Bindings.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/tables/TableFormats.h"

namespace smat::python {

namespace {

using Table = std::shared_ptr<ResultTable>;
using State = std::vector<std::tuple<std::string, std::string, Numbers>>;

py::array_t<double> columnOf(const py::object& self, const std::string& key) {
    const ResultTable& table = *self.cast<Table>();
    const ResultColumn* column = table.find(key);
    if (column == nullptr)
        throw py::key_error(key);
    return viewOf(column->values, self);
}

std::vector<std::string> keysOf(const ResultTable& table) {
    std::vector<std::string> keys;
    for (const ResultColumn& column : table.columns())
        keys.push_back(column.key);
    return keys;
}

} // namespace

void addTables(py::module_& module) {
    py::class_<ResultTable, Table>(module, "Table", R"(Columns of numbers with units and provenance.

The first columns say where a row is (azimuth, range, wavelength, ...). A table works like a dict of
arrays: ``table['contrast_intensity']``.
)")
        .def_static(
            "load",
            [](const std::filesystem::path& file) {
                return withoutLock(
                    [&] { return std::make_shared<ResultTable>(ResultTable::load(file)); });
            },
            py::arg("file"), R"(Read a table that was saved as .csv or .json.

Raises
------
InputError
    For a file that is no such table, with every line that is wrong.
)")
        .def(
            "save",
            [](const ResultTable& table, const std::filesystem::path& file) {
                withoutLock([&] {
                    if (tableFormatOf(file) != nullptr)
                        saveTable(table, file);
                    else
                        table.save(file);
                });
            },
            py::arg("file"),
            R"(Write .csv or .json; of a table over directions also .mat and .nc, where they were built.

Raises
------
InputError
    For a file that cannot be written or a table that does not fit the form.
)")
        .def("keys", &keysOf, "Names of the columns in their order.")
        .def(
            "values",
            [](const py::object& self) {
                std::vector<py::array_t<double>> arrays;
                for (const std::string& key : keysOf(*self.cast<Table>()))
                    arrays.push_back(columnOf(self, key));
                return arrays;
            },
            "The columns in their order.")
        .def(
            "items",
            [](const py::object& self) {
                std::vector<std::pair<std::string, py::array_t<double>>> items;
                for (const std::string& key : keysOf(*self.cast<Table>()))
                    items.emplace_back(key, columnOf(self, key));
                return items;
            },
            "Names and columns in their order.")
        .def("__getitem__", &columnOf, py::arg("key"),
             "A column, shape (rows,), float64, without a copy; read-only. KeyError for another.")
        .def("__contains__", [](const ResultTable& table,
                                const std::string& key) { return table.find(key) != nullptr; })
        .def("__iter__", [](const ResultTable& table) { return py::iter(py::cast(keysOf(table))); })
        .def("__len__", [](const ResultTable& table) { return table.columns().size(); })
        .def_property_readonly("rows", &ResultTable::rowCount, "How many rows there are.")
        .def_property_readonly(
            "units",
            [](const ResultTable& table) {
                py::dict units;
                for (const ResultColumn& column : table.columns())
                    units[py::str(column.key)] = column.unit;
                return units;
            },
            "Units by column, '' for numbers without one.")
        .def_property_readonly(
            "provenance", [](const ResultTable& table) { return table.provenance.entries; },
            "How the numbers came to be: pairs of key and value in their order; a key may repeat.")
        .def_property_readonly(
            "warnings", &ResultTable::warnings,
            "What each row warns of, '' for nothing; an empty list where no row warns of anything.")
        .def("to_csv", &ResultTable::toCsv, "The text of the .csv file.")
        .def("to_json", &ResultTable::toJson, "The text of the .json file.")
        .def(
            "to_numpy",
            [](const ResultTable& table) {
                py::array_t<double> all({table.rowCount(), table.columns().size()});
                auto numbers = all.mutable_unchecked<2>();
                for (std::size_t column = 0; column < table.columns().size(); ++column)
                    for (std::size_t row = 0; row < table.rowCount(); ++row)
                        numbers(static_cast<py::ssize_t>(row), static_cast<py::ssize_t>(column)) =
                            table.columns()[column].values[row];
                return all;
            },
            "All numbers as one array, shape (rows, columns).")
        .def(
            "to_pandas",
            [](const py::object& self) {
                return py::module_::import("smat._tables").attr("to_pandas")(self);
            },
            "A pandas.DataFrame with the units in its `attrs`. ImportError without pandas.")
        .def(
            "to_xarray",
            [](const py::object& self) {
                return py::module_::import("smat._tables").attr("to_xarray")(self);
            },
            "An xarray.Dataset over the first column, or over the grid of a table of directions. "
            "ImportError without xarray.")
        .def("__eq__", [](const ResultTable& a, const ResultTable& b) { return a == b; })
        .def("__eq__", [](const ResultTable&, const py::object&) { return false; })
        .def("__repr__",
             [](const ResultTable& table) {
                 std::string text = "Table of " + std::to_string(table.rowCount()) + " rows:";
                 for (const ResultColumn& column : table.columns())
                     text += (&column == table.columns().data() ? " " : ", ") + column.header();
                 return text;
             })
        .def(py::pickle(
            [](const ResultTable& table) {
                py::list columns;
                for (const ResultColumn& column : table.columns())
                    columns.append(py::make_tuple(column.key, column.unit, arrayOf(column.values)));
                return py::make_tuple(columns, table.provenance.entries, table.warnings());
            },
            [](const py::tuple& state) {
                auto table = std::make_shared<ResultTable>();
                for (const auto& [key, unit, values] : state[0].cast<State>())
                    table->add(key, unit).values = vectorOf(values, "column");
                table->provenance.entries =
                    state[1].cast<std::vector<std::pair<std::string, std::string>>>();
                const auto warnings = state[2].cast<std::vector<std::string>>();
                for (std::size_t row = 0; row < warnings.size(); ++row)
                    table->setWarning(row, warnings[row]);
                return table;
            }))
        .attr("__hash__") = py::none();
}

} // namespace smat::python
