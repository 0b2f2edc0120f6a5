#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace smat {

/// How far a long job is.
struct Progress {
    std::size_t done = 0;
    std::size_t total = 0;
    double elapsed_s = 0.0;
    std::string what; ///< "polar: angle 40 deg"

    double fraction() const {
        return total == 0 ? 0.0 : static_cast<double>(done) / static_cast<double>(total);
    }
    /// From the pace so far; no value before the first case is done.
    std::optional<double> remaining_s() const;
    /// For people, with the stage of the renderer in a case where there is one:
    /// "polar: azimuth 0 deg  0/72  0 %  3.0 s  inter-reflection: pairs, 43 %".
    std::string text(const std::string& stage = {}) const;
};

/// Called from the thread that works, before the first case and after each.
using ProgressCallback = std::function<void(const Progress&)>;

} // namespace smat
