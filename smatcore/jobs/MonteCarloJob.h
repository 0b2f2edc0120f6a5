#pragma once

#include <filesystem>
#include <vector>

#include "smatcore/analysis/CaseFile.h"
#include "smatcore/analysis/MonteCarloData.h"
#include "smatcore/simulate/ScenarioMonteCarlo.h"

namespace smat {

/// A Monte Carlo run of an analysis with the files its result goes to.
struct MonteCarloJob {
    MonteCarloData data = {};
    /// Tables and raw draws, .csv or .json. None: the result stays in the data.
    std::vector<std::filesystem::path> files = {}, realisationFiles = {};
    CaseShare share = {};
    /// Case by case, each with all of its draws, into the table alone; a team always runs so.
    bool isInParts = false;
    bool resumes = false; ///< of a run in parts that was ended
};

/// A Monte Carlo run of a scenario with the files its result goes to.
struct ScenarioMonteCarloJob {
    ScenarioMonteCarlo run = {};
    std::vector<std::filesystem::path> files = {}, realisationFiles = {};
};

} // namespace smat
