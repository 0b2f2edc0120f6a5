#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "python/src/OpenProjects.h"
#include "python/src/Results.h"
#include "smatcore/analysis/MonteCarloData.h"
#include "smatcore/support/NearestNames.h"

namespace smat::python {

namespace {

using Draws = std::shared_ptr<MonteCarloData>;

MonteCarloOptions optionsOf(const py::dict& given) {
    MonteCarloOptions options;
    const auto take = [&](const char* key, auto& into) {
        if (given.contains(key) && !given[key].is_none())
            into = given[key].cast<std::decay_t<decltype(into)>>();
    };
    const auto word = [&](const char* key, const std::string& otherwise) {
        return given.contains(key) ? given[key].cast<std::string>() : otherwise;
    };
    take("samples", options.samples);
    take("percentiles", options.percentiles);
    take("standard_error", options.standardError);
    take("subpixel_shifts", options.subpixelShifts);
    take("ranking", options.ranking);
    take("ranking_pairs", options.rankingPairs);
    take("ranking_at", options.rankingAt);
    options.ranking = options.ranking || options.rankingAt;
    const std::string sequence = word("sequence", "sobol");
    if (sequence != "sobol" && sequence != "plain")
        throw badArgument("sequence", sequence, oneOf({"sobol", "plain"}, sequence));
    options.sequence =
        sequence == "plain" ? RealisationSequence::plain : RealisationSequence::sobol;
    const std::string quantity = word("quantity", name(options.quantity));
    const auto knownQuantity = monteCarloQuantity(quantity);
    if (!knownQuantity)
        throw badArgument("quantity", quantity,
                          oneOf({"contrast_intensity", "intensity", "irradiance"}, quantity));
    options.quantity = *knownQuantity;
    const std::string statistic = word("statistic", name(options.statistic));
    const auto knownStatistic = statisticFromName(statistic);
    if (!knownStatistic)
        throw badArgument("statistic", statistic,
                          "mean, standard-deviation, or a percentile such as p95");
    options.statistic = *knownStatistic;
    options.check();
    return options;
}

Draws drawn(const OpenProject& open, const std::string& kind, const std::string& analysis,
            const py::dict& options, const py::object& progress) {
    prepareProcess();
    auto job = std::make_shared<MonteCarloJob>();
    job->data.options = optionsOf(options);
    job->data.analysis = analysisOf(open, kind, analysis);
    job->data.analysis.commandLine = job->data.equivalentCommand("montecarlo.csv");
    PythonProgress watch(progress);
    withoutLock([&] {
        const Pool<JobRunner>::Lease runner(*open.runners);
        runner->scenes().setDatabaseOverrides(open.databases);
        runner->run(*job, {.progress = watch.callback(), .stop = watch.stop()});
    });
    watch.finish();
    warnOf(job->data.analysis.warnings);
    return {job, &job->data};
}

py::array_t<double> valuesOfDraws(const MonteCarloData& data) {
    py::array_t<double> all({data.values.size(), data.realisations()});
    double* into = all.mutable_data();
    for (const std::vector<double>& place : data.values)
        into = std::ranges::copy(place, into).out;
    return all;
}

} // namespace

void addMonteCarlo(py::module_& module, ProjectClass& project) {
    py::class_<MonteCarloData, Draws>(
        module, "MonteCarloResult", "What an analysis gives over the scales of its scaling files.")
        .def_property_readonly(
            "table",
            [](const Draws& data) {
                return std::shared_ptr<ResultTable>(data, &data->analysis.table);
            },
            "The Table: a row for each abscissa with nominal, mean, percentiles and their errors.")
        .def_property_readonly(
            "values", &valuesOfDraws,
            "The quantity of each draw, shape (places, draws): all abscissae in the first band, "
            "then in the next.")
        .def_property_readonly(
            "abscissae", [](const MonteCarloData& data) { return arrayOf(data.abscissae); },
            "Abscissae, shape (n,); wavelengths of a spectrum, um.")
        .def_readonly("unit", &MonteCarloData::unit, "The unit of the values.")
        .def_readonly("seed", &MonteCarloData::seed, "The seed of the draws.")
        .def_property_readonly(
            "scales",
            [](const MonteCarloData& data) {
                std::vector<std::string> names;
                for (const SceneScaling& scaling : data.scalings)
                    names.push_back(scaling.name);
                return names;
            },
            "Names of the scales that are drawn.")
        .def_property_readonly(
            "warnings", [](const MonteCarloData& data) { return data.analysis.warnings; },
            "What there is to warn of.")
        .def_property_readonly(
            "is_complete",
            [](const MonteCarloData& data) {
                return data.analysis.state == AnalysisState::complete;
            },
            "False where it was stopped.");
    project.def("monte_carlo", &drawn, py::arg("kind"), py::arg("analysis"), py::arg("options"),
                py::arg("progress"));
}

} // namespace smat::python
