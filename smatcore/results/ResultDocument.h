#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/MonteCarlo.h"

namespace smat {

/// A result as it is kept: what came out, what was asked, and what people called it.
struct ResultDocument {
    enum class Origin {
        run,        ///< of an analysis or a Monte Carlo run: it can be run again
        file,       ///< opened from a file, which keeps the numbers
        difference, ///< of two others
        tool        ///< what a tool computed
    };

    std::string title;
    std::string notes;
    Origin origin = Origin::run;
    std::string madeAt;                       ///< ISO 8601, local time: "2026-11-23T07:02:11"
    std::shared_ptr<const AnalysisData> data; ///< never null
    /// Of a Monte Carlo run, whose analysis `data` is; else null.
    std::shared_ptr<const MonteCarloData> monteCarlo = {};
    std::filesystem::path file = {}; ///< of Origin::file
};

} // namespace smat
