#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/CaseStore.h"
#include "smatcore/simulate/SceneGenerator3D.h"
#include "smatcore/support/Progress.h"
#include "smatcore/support/StageTimer.h"

namespace smat {

/// Which frames of a scenario are wanted.
struct SimulationRequest {
    std::vector<std::string> sensors; ///< by name; empty: all
    std::optional<double> from_s, to_s;
};

/// The steps and sensors that are wanted. Frames keep the numbers that their steps have in the
/// whole scenario.
struct SimulationPlan {
    struct Step {
        std::size_t number = 0;
        double time_s = 0.0;
    };
    std::vector<Step> steps;          ///< at least one
    std::vector<std::size_t> sensors; ///< at least one, in the order of the scenario

    std::vector<double> times_s() const;
};

/// Throws InputError naming sensors that are not known, and times between which no step lies.
SimulationPlan planSimulation(const Scenario& scenario, const SimulationRequest& request);

/// What came out of one sensor.
struct SensorResult {
    std::size_t sensor = 0;
    std::string name;
    std::size_t frames = 0;        ///< made, of all bands
    std::size_t framesMissing = 0; ///< steps without a frame: its mount or its target was not there
    /// A row a step: `time [s]`, `frame`, `irradiance_total [W m-2]` of the whole frame, and for
    /// each entity `NAME.range [m]`, `NAME.intensity [W sr-1]`, `NAME.contrast_intensity [W sr-1]`,
    /// `NAME.irradiance [W m-2]` of the contrast, and `NAME.pixels`; nan where it is not there. Of
    /// several bands each but the range is there in every band, `NAME.intensity@3-5um [W sr-1]`.
    /// With `render.errors` those of intensity, contrast and irradiance stand behind the numbers of
    /// an entity's band, `error_NAME.intensity [W sr-1]`.
    ResultTable table;
    std::vector<std::string> providedBy;
    std::vector<std::string> warnings; ///< each said once
    /// Where frames and table were written, by writeSimulation; a part has no table.
    std::filesystem::path folder = {}, tableFile = {};
};

struct SimulationResult {
    AnalysisState state = AnalysisState::notRun;
    std::vector<SensorResult> sensors; ///< in the order of the plan
    double elapsed_s = 0.0;
};

/// Takes each frame as soon as it is made; the number is that of its step.
using FrameSink = std::function<void(SensorFrame&, std::size_t number)>;

/// Where the steps of a run in parts come from and go to: cases of a store for each sensor, of
/// which one has the row of its table, none where it makes no frame. The frames of steps that are
/// known are where they were put then.
struct SimulationSteps {
    std::vector<CaseStore*> stores; ///< by sensor of the plan
    /// Of a sensor's table before its first row.
    std::function<Provenance(const SensorResult&)> provenance;
};

/// Makes the frames of a plan, step by step, each for every sensor. Places are checked for all
/// steps before the first drawing. What is in `result` stays there when an exception passes or a
/// stop is asked for; it is complete where every step is in it. Throws InputError.
void runSimulation(SceneGenerator3D& generator, const SimulationPlan& plan, const FrameSink& sink,
                   SimulationResult& result, const ProgressCallback& progress = {},
                   std::stop_token stop = {}, StageTimer* timer = nullptr,
                   const SimulationSteps* steps = nullptr);

} // namespace smat
