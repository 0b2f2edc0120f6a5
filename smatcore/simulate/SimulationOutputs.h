#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/simulate/FrameFiles.h"
#include "smatcore/simulate/SceneGenerator3D.h"

namespace smat {

/// The files that a simulation writes if it comes to its end, for those that announce, check and
/// make them.
struct SimulationOutputs {
    struct OfSensor {
        std::size_t sensor = 0;
        std::vector<SimulationPlan::Step> steps;   ///< at which it has frames
        std::vector<std::filesystem::path> frames; ///< of all steps, bands and forms, as written
        std::filesystem::path table, settings;     ///< CSV, ImagingSensor
    };
    std::vector<OfSensor> sensors; ///< in the order of the plan
    /// Films, each with its files: one, or the numbered pictures of a .png.
    std::vector<std::vector<std::filesystem::path>> films;
};

/// Of the steps of a plan that are `mine`, a number from 0 in the plan, all where it is empty;
/// `film` is empty for none. Nothing is rendered.
SimulationOutputs outputsOf(const SceneGenerator3D& generator, const SimulationPlan& plan,
                            const FrameFiles& files, const std::filesystem::path& film,
                            const std::function<bool(std::size_t step)>& mine = {});

/// "a.exr", of several "a.exr to b.exr".
std::string firstToLast(const std::vector<std::filesystem::path>& files);

} // namespace smat
