#include <map>
#include <memory>
#include <optional>
#include <string>

#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/model/ModelUse.h"
#include "irsg/radiometry/Band.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/SignatureFile.h"
#include "python/src/Bindings.h"

namespace smat::python {

namespace {

namespace fs = std::filesystem;
using irsg::Finding;
using irsg::SignatureDatabase;
using Database = std::shared_ptr<SignatureDatabase>;

Database databaseOfText(const std::string& text, const std::string& file) {
    return std::make_shared<SignatureDatabase>(
        irsg::signatureFromJson(text, file, irsg::LintErrors::accept));
}

Database loadDatabase(const fs::path& file, bool acceptChanges, bool acceptErrors) {
    const auto errors = acceptErrors ? irsg::LintErrors::accept : irsg::LintErrors::refuse;
    if (file.extension() == ".json")
        return std::make_shared<SignatureDatabase>(
            irsg::signatureFromJson(irsg::readFile(file), file.string(), errors));
    return std::make_shared<SignatureDatabase>(
        irsg::loadSignatureFile(
            file, acceptChanges ? irsg::OutsideChanges::accept : irsg::OutsideChanges::refuse,
            errors)
            .database);
}

void saveDatabase(const SignatureDatabase& database, const fs::path& file) {
    if (file.extension() == ".json")
        irsg::writeFileDurably(file, irsg::signatureToJson(database));
    else
        irsg::saveSignatureFile(database, file);
}

irsg::LintScope scopeOf(const std::optional<irsg::Band>& band,
                        const std::shared_ptr<irsg::Model>& model) {
    irsg::LintScope scope;
    if (band)
        scope.bands = {band->range()};
    if (model)
        scope.models = {irsg::useOf(*model)};
    return scope;
}

void addFinding(py::module_& module) {
    py::class_<Finding>(module, "Finding", "One thing of a signature database to look at.")
        .def_property_readonly(
            "severity",
            [](const Finding& finding) { return finding.isError() ? "error" : "warning"; },
            "'error': physically wrong, neither loaded nor saved; 'warning': hardly meant.")
        .def_readonly("entry", &Finding::entry, "'materials.3'.")
        .def_readonly("place", &Finding::place, "'materials.3.emissivity at 4.2 um'.")
        .def_readonly("value", &Finding::value, "What was found.")
        .def_readonly("reason", &Finding::reason, "What was expected, and why.")
        .def_readonly("remedy", &Finding::remedy, "What would repair it; may be empty.")
        .def_property_readonly(
            "is_repairable",
            [](const Finding& finding) { return finding.repair && !finding.removes; },
            "Whether repaired() does it.")
        .def("__repr__", [](const Finding& finding) {
            return std::string(finding.isError() ? "error: " : "warning: ") + finding.place +
                   ": found " + finding.value + ": " + finding.reason;
        });
}

} // namespace

void addSignatures(py::module_& module) {
    addFinding(module);
    py::class_<SignatureDatabase, Database>(
        module, "SignatureDatabase",
        R"(Temperatures and materials behind the codes of a model.

A value: it is not changed; replaced() gives another one.

Parameters
----------
text : str
    The JSON form (docs/formats-sigdb.md).
file : str
    How errors call the text.

Raises
------
InputError
    With the key path of everything that cannot be.
)")
        .def(py::init(&databaseOfText), py::arg("text"), py::arg("file") = "JSON")
        .def_static(
            "load",
            [](const fs::path& file, bool acceptChanges, bool acceptErrors) {
                return withoutLock([&] { return loadDatabase(file, acceptChanges, acceptErrors); });
            },
            py::arg("file"), py::kw_only(), py::arg("accept_changes") = false,
            py::arg("accept_errors") = false, R"(Read a .sigdb file, or its JSON form.

Parameters
----------
file : str or os.PathLike
    The file.
accept_changes : bool
    Whether entries that another program has changed are taken.
accept_errors : bool
    Whether a database that is physically wrong is taken, to be repaired.

Raises
------
InputError
    For a file that is damaged, newer, physically wrong or changed outside.
)")
        .def(
            "save",
            [](const SignatureDatabase& database, const fs::path& file) {
                withoutLock([&] { saveDatabase(database, file); });
            },
            py::arg("file"), R"(Write .sigdb or .json, whole or not at all.

Raises
------
InputError
    For a database that is physically wrong, and a file that cannot be written.
)")
        .def("to_json", &irsg::draftToJson, "The JSON form, also of a database that is wrong.")
        .def(
            "to_dict",
            [](const SignatureDatabase& database) {
                return py::module_::import("json").attr("loads")(irsg::draftToJson(database));
            },
            "The JSON form as Python values; SignatureDatabase(json.dumps(d)) reads it back.")
        .def(
            "__getitem__",
            [](const py::object& self, const std::string& path) {
                return py::module_::import("smat._signatures").attr("value_at")(self, path);
            },
            py::arg("path"), "A value by its key path, such as 'materials.1.emissivity'.")
        .def(
            "replaced",
            [](const py::object& self, const py::dict& values) {
                return py::module_::import("smat._signatures").attr("replaced")(self, values);
            },
            py::arg("values"), R"(The database with other values.

Parameters
----------
values : dict of str to object
    New values by key path, such as ``{'materials.1.emissivity': 0.9}``; a spectrum is a
    Spectrum, or rows of wavelength, um, and value.

Raises
------
InputError
    With the key path of a value that cannot be.
KeyError
    For an entry that is not there.
)")
        .def(
            "lint",
            [](const SignatureDatabase& database, const std::optional<irsg::Band>& band,
               const std::shared_ptr<irsg::Model>& model) {
                return withoutLock([&] { return irsg::lint(database, scopeOf(band, model)); });
            },
            py::arg("band") = py::none(), py::arg("model") = py::none(),
            R"(Check the physics: energy, units, temperatures, loops, coverage.

Parameters
----------
band : Band, optional
    What spectra should cover.
model : Model, optional
    Whose codes should have entries.

Returns
-------
list of Finding
    In the order of the database; empty where nothing is suspicious.
)")
        .def(
            "repaired",
            [](const SignatureDatabase& database, const std::optional<irsg::Band>& band,
               const std::shared_ptr<irsg::Model>& model) {
                auto repaired = std::make_shared<SignatureDatabase>(database);
                auto findings =
                    withoutLock([&] { return irsg::repairAll(*repaired, scopeOf(band, model)); });
                return py::make_tuple(repaired, findings);
            },
            py::arg("band") = py::none(), py::arg("model") = py::none(),
            "The database with what can be repaired without removing anything, and the list of "
            "findings that were repaired.")
        .def_readonly("title", &SignatureDatabase::title, "Its title.")
        .def_property_readonly(
            "material_names",
            [](const SignatureDatabase& database) {
                std::map<int, std::string> names;
                for (const auto& [index, material] : database.materials)
                    names[index] = material.name;
                return names;
            },
            "Names of the materials by index.")
        .def_property_readonly(
            "temperature_names",
            [](const SignatureDatabase& database) {
                std::map<int, std::string> names;
                for (const auto& [index, entry] : database.temperatures)
                    names[index] = entry.name;
                return names;
            },
            "Names of the temperature entries by index.")
        .def("__eq__",
             [](const SignatureDatabase& a, const SignatureDatabase& b) { return a == b; })
        .def("__eq__", [](const SignatureDatabase&, const py::object&) { return false; })
        .def("__repr__",
             [](const SignatureDatabase& database) {
                 return "SignatureDatabase '" + database.title +
                        "': " + std::to_string(database.materials.size()) + " materials, " +
                        std::to_string(database.temperatures.size()) + " temperatures, " +
                        std::to_string(database.spectra.size()) + " spectra";
             })
        .def(py::pickle(&irsg::draftToJson,
                        [](const std::string& text) { return databaseOfText(text, "pickle"); }))
        .attr("__hash__") = py::none();
}

} // namespace smat::python
