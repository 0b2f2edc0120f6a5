#pragma once

#include <string>
#include <vector>

#include "smatcore/analysis/MonteCarlo.h"
#include "smatcore/simulate/Simulation.h"

namespace smat {

/// What is seen of one entity, or of all together, by one sensor: its values over the times at
/// which both are there.
struct ScenarioDistribution {
    std::string sensor;
    std::string entity; ///< empty: all together
    MonteCarloData data;

    /// "mwir-near", "mwir" of all together.
    std::string label() const { return entity.empty() ? sensor : sensor + "-" + entity; }
};

/// What a Monte Carlo run over a scenario was asked, and what came of it.
struct ScenarioMonteCarlo {
    LoadedScenario scenario; ///< loaded with `scaling.use` off: scales are drawn here
    SimulationPlan plan;
    MonteCarloOptions options; ///< without a ranking and with one subpixel shift
    std::string commandLine;   ///< goes into the provenance where it is not empty

    AnalysisState state = AnalysisState::notRun;
    /// Sensor after sensor: each entity that it ever sees, behind them all together where there
    /// are several.
    std::vector<ScenarioDistribution> parts;
    std::vector<std::string> warnings; ///< each said once
    double elapsed_s = 0.0;
};

/// Repeats the steps of a scenario over the scales of the files beside its models. Every sensor and
/// every step has the same scales in a draw; entities keep theirs for all of it. Geometry is drawn
/// once for each sensor and step, so the number of draws costs little. The seed is `scaling.seed`
/// of the first sensor of the plan. A stop keeps whole steps and draws, marked partial. Throws
/// InputError: options that cannot be, no scaling file, no scale that varies, more than 5e7 values.
void runScenarioMonteCarlo(ScenarioMonteCarlo& run, const RenderDoor& door,
                           const ProgressCallback& progress = {}, std::stop_token stop = {},
                           StageTimer* timer = nullptr);

/// Throws all that the run would refuse but for what only drawing shows; the warnings are those
/// that there are by then.
void rehearseScenarioMonteCarlo(ScenarioMonteCarlo& run, const RenderDoor& door);

/// All that a run of this plan may write by saveDistributions of `file`, and by
/// saveScenarioRealisations.
std::vector<std::filesystem::path> distributionFiles(const ScenarioMonteCarlo& run,
                                                     const std::filesystem::path& file);
std::vector<std::filesystem::path> realisationFiles(const ScenarioMonteCarlo& run,
                                                    const std::filesystem::path& file);
/// Writes the bands of each part, FILE-mwir-near.csv, or everything of it as .json. Returns the
/// files. Throws InputError.
std::vector<std::filesystem::path> saveDistributions(const ScenarioMonteCarlo& run,
                                                     const std::filesystem::path& file);
/// Writes the raw draws of each sensor, FILE-mwir.csv: a row a draw with its scales and what is
/// seen of every entity at every time, `near.contrast_intensity at 2 s`.
std::vector<std::filesystem::path> saveScenarioRealisations(const ScenarioMonteCarlo& run,
                                                            const std::filesystem::path& file);

} // namespace smat
