#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/CalculationConfigurations.h"
#include "smatcore/support/Progress.h"

namespace smat {

/// Every way to calculate a view, with what it costs and how wrong it is: the modes of
/// antialiasing, bins of computed air and wideband-ck, rows of the background, and less and less
/// of the light.
///
/// True errors are differences to windows of 2048 samples, bins of 1 cm-1 and 128 rows, with all
/// light: the larger one of intensity and contrast, in any band. Times are those of a case that
/// shares neither drawing nor line of sight with another, by the clock of the wall.
class CostAccuracyStudy {
  public:
    /// How much of the light, as the column `light` tells.
    enum Light { noLight, sunAndSky, withShadows, allLight };

    struct Configuration {
        CalculationConfiguration configuration;
        int antialiasing; ///< 0 to 5
        Light light;
    };
    struct Options {
        std::size_t repeats = 2; ///< each time is the least of so many cases
        /// Each choice alone, then the ways that may be on the front by what these showed and a
        /// model of costs; else all.
        bool likely = false;
    };
    /// " --repeats 3 --configurations likely": of what is not the default.
    static std::string optionWords(const Options& options);

    /// How many ways there are, how many of them are each choice alone, and about how long the
    /// likely ones, or all, take by the model of costs.
    struct Size {
        std::size_t all = 0, alone = 0;
        double least_s = 0.0, most_s = 0.0;
    };
    /// Reads air and response, no model. Throws InputError.
    static Size sizeOf(const Project& project, const Settings& settings, const Options& options);

    /// What its results are of: a tool.
    static AnalysisKind kind();
    /// Those that differ in this scene. `wideband`: quadrature points may be trained.
    static std::vector<Configuration> configurationsOf(const SceneDescription& scene,
                                                       bool wideband);
    static CalculationConfiguration finest(const SceneDescription& scene);

    /// The settings that make a row of its table the way of a project, and no others: antialiasing,
    /// mode, bins, background rows and what of the light is off; no target error, which would
    /// choose another way.
    static Settings settingsOf(const ResultTable& table, std::size_t row);

    /// Throws InputError where run() would, by what can be seen without drawing.
    static void rehearse(AnalysisData& data, const RenderDoor& door, const SceneFactory& scenes,
                         const Options& options);
    /// Draws the view of `data.settings` in all of them and fills the table, by ascending error.
    /// Says which way is the quickest whose true error is at most the target error of the settings,
    /// or 1 %. A stop leaves the ways that were done, marked partial.
    static void run(AnalysisData& data, const RenderDoor& door, const SceneFactory& scenes,
                    const Options& options, const ProgressCallback& progress = {},
                    std::stop_token stop = {});
};

} // namespace smat
