#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace smat {

/// `smat plot RESULT... -o FILE`: the window's plots without a window.
struct PlotRequest {
    std::vector<std::filesystem::path> results; ///< overlaid
    std::filesystem::path output;               ///< .svg, .pdf, .png or .csv
    std::string quantity;                       ///< column key; the favourite one where empty
    bool logX = false, logY = false;            ///< Cartesian plots only
    bool decibel = false;                       ///< polar plots and signature tables
    /// "range=3000": of a signature table, which of several ranges and states is drawn.
    std::vector<std::string> at;
};

/// Needs a QApplication, on the offscreen platform where there is no display. Throws
/// irsg::InputError, also for an option that does not belong to this kind of plot.
void plot(const PlotRequest& request);

} // namespace smat
