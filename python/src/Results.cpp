#include "python/src/Results.h"

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "smatcore/analysis/ResultFile.h"
#include "smatcore/project/ProjectFile.h"

namespace smat::python {

namespace {

using Result = std::shared_ptr<AnalysisData>;
using Summary = std::vector<std::tuple<std::string, double, std::string>>;

Summary summaryOf(const AnalysisData& data) {
    Summary summary;
    for (const SummaryItem& item : data.summary)
        summary.emplace_back(item.label, item.value, item.unit);
    return summary;
}

std::map<std::string, std::string> textsOf(const Settings& settings) {
    return {settings.values().begin(), settings.values().end()};
}

Settings settingsFrom(const std::map<std::string, std::string>& texts) {
    Settings settings;
    for (const auto& [key, text] : texts)
        settings.set(key, text, "pickle");
    return settings;
}

std::shared_ptr<irsg::RadianceImage> imageOfResult(const Result& data) {
    if (data->image.empty())
        return nullptr;
    return {data, &data->image};
}

py::tuple stateOfResult(const Result& data) {
    py::dict image;
    if (!data->image.empty())
        image["image"] = imageOfResult(data);
    return py::make_tuple(data->name, name(data->kind), static_cast<int>(data->state),
                          data->project.file, projectToJson(data->project, data->project.file),
                          textsOf(data->settings), data->commandLine, image,
                          std::shared_ptr<ResultTable>(data, &data->table), summaryOf(*data),
                          data->providedBy, data->warnings, data->renderer, data->elapsed_s);
}

Result resultOfState(const py::tuple& state) {
    auto data = std::make_shared<AnalysisData>();
    data->name = state[0].cast<std::string>();
    data->kind = resultKindFromName(state[1].cast<std::string>());
    data->state = static_cast<AnalysisState>(state[2].cast<int>());
    data->project =
        projectFromJson(state[4].cast<std::string>(), state[3].cast<std::filesystem::path>());
    data->settings = settingsFrom(state[5].cast<std::map<std::string, std::string>>());
    data->commandLine = state[6].cast<std::string>();
    const auto image = state[7].cast<py::dict>();
    if (image.contains("image"))
        data->image = image["image"].cast<const irsg::RadianceImage&>();
    data->table = state[8].cast<const ResultTable&>();
    for (const auto& [label, value, unit] : state[9].cast<Summary>())
        data->summary.push_back({label, value, unit});
    data->providedBy = state[10].cast<std::vector<std::string>>();
    data->warnings = state[11].cast<std::vector<std::string>>();
    data->renderer = state[12].cast<std::string>();
    data->elapsed_s = state[13].cast<double>();
    return data;
}

} // namespace

void PythonProgress::tell(const Progress& progress) {
    const py::gil_scoped_acquire lock;
    if (raised_)
        return;
    try {
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        if (!function_.is_none() && function_(progress).is(py::bool_(false)))
            stop_.request_stop();
    } catch (...) {
        raised_ = std::current_exception();
        stop_.request_stop();
    }
}

void addResults(py::module_& module) {
    py::class_<Progress>(module, "Progress", "How far a job is.")
        .def_readonly("done", &Progress::done, "Cases that are done.")
        .def_readonly("total", &Progress::total, "Cases in all.")
        .def_readonly("elapsed_s", &Progress::elapsed_s, "Time since the start, s.")
        .def_property_readonly("remaining_s", &Progress::remaining_s,
                               "Estimated time to the end, s; None before the first case.")
        .def_readonly("what", &Progress::what, "'polar: angle 40 deg'.")
        .def("__repr__", [](const Progress& progress) {
            return std::to_string(progress.done) + " of " + std::to_string(progress.total) + ": " +
                   progress.what;
        });
    py::class_<AnalysisData, Result>(module, "Result", R"(What an analysis gave.

As the command line and the window have it: a table of every kind, an image of image analyses, and
all that says how it came to be.
)")
        .def_static(
            "load",
            [](const std::filesystem::path& file) {
                return withoutLock(
                    [&] { return std::make_shared<AnalysisData>(loadResult(file)); });
            },
            py::arg("file"),
            R"(Read a result that was saved, or an image or table of another program.

Raises
------
InputError
    For a file that is missing, damaged or of another kind.
)")
        .def(
            "save",
            [](const AnalysisData& data, const std::filesystem::path& file) {
                withoutLock([&] { saveResult(data, file); });
            },
            py::arg("file"),
            R"(Write the result as `smat-batch --out` does, in the form of the extension.

Raises
------
InputError
    For another extension, listing those there are, and where the file cannot be written.
)")
        .def_readonly("name", &AnalysisData::name, "Its name in the project, or its kind.")
        .def_property_readonly(
            "kind", [](const AnalysisData& data) { return name(data.kind); }, "'polar'.")
        .def_property_readonly(
            "is_complete",
            [](const AnalysisData& data) { return data.state == AnalysisState::complete; },
            "False where it was stopped.")
        .def_property_readonly(
            "table",
            [](const Result& data) { return std::shared_ptr<ResultTable>(data, &data->table); },
            "The Table; of an image one row of sums.")
        .def_property_readonly("image", &imageOfResult, "The Image; None of other analyses.")
        .def_property_readonly("summary", &summaryOf,
                               "Numbers worth saying: tuples of label, value and unit.")
        .def_readonly("warnings", &AnalysisData::warnings, "What there is to warn of.")
        .def_readonly("provided_by", &AnalysisData::providedBy,
                      "Which atmosphere provided what: 'transmittance: vacuum'.")
        .def_readonly("renderer", &AnalysisData::renderer, "What rendered it.")
        .def_readonly("command", &AnalysisData::commandLine,
                      "The command that does the same from a terminal, of files as they are.")
        .def_readonly("elapsed_s", &AnalysisData::elapsed_s, "Wall time, s.")
        .def("__repr__",
             [](const AnalysisData& data) {
                 return "Result " + data.name + " of kind " + name(data.kind) + ", " +
                        std::to_string(data.table.rowCount()) + " rows";
             })
        .def(
            "_repr_png_",
            [](const Result& data) -> py::object {
                if (data->image.empty())
                    return py::none();
                return py::cast(imageOfResult(data)).attr("_repr_png_")();
            },
            "The picture of an image, for notebooks; None of other results.")
        .def(py::pickle(&stateOfResult, &resultOfState));
}

} // namespace smat::python
