#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/analysis/CaseFile.h"
#include "smatcore/simulate/Film.h"
#include "smatcore/simulate/Simulation.h"

namespace smat {

/// A scenario whose frames and tables are to be written into a folder.
struct SimulationJob {
    Scenario scenario;
    EditedTrajectories trajectories = {}; ///< in place of those in its files
    Settings overrides = {};              ///< for all sensors
    SimulationRequest request = {};
    std::filesystem::path folder = {};
    std::vector<std::string> extensions{".exr"};
    std::filesystem::path film = {}; ///< .mp4, .gif, .png; empty: none
    bool keepsStrips = false;        ///< for films that are made afterwards
    std::string commandLine = {};    ///< for the provenance; empty where none does the same
    CaseShare share = {};
    /// The steps stand in files beside the tables until these are written; a team always runs so.
    bool isInParts = false;
    bool resumes = false; ///< of a run in parts that was ended
};

/// A simulation whose steps are counted and whose files are read.
struct PlannedSimulation : SimulationJob {
    SimulationPlan plan;
    LoadedScenario loaded;

    /// The files of this simulation, which must outlive them.
    FrameFiles files() const { return {loaded, folder, extensions, commandLine}; }
};

} // namespace smat
