#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/image/RadianceImage.h"
#include "smatcore/simulate/Film.h"
#include "smatcore/simulate/Simulation.h"

namespace smat::gui {

/// A scenario whose frames and tables are to be written into a folder.
struct SimulationOrder {
    Scenario scenario;
    EditedTrajectories trajectories; ///< as they are edited
    SimulationRequest request;
    std::filesystem::path folder;
    std::vector<std::string> extensions{".exr"};
    std::string commandLine; ///< empty where none does the same
};

/// A frame that was written, small enough to be kept and shown in a row of all.
struct WrittenFrame {
    std::size_t sensor = 0, band = 0, number = 0;
    double time_s = 0.0;
    int width = 0, height = 0;    ///< of the thumbnail
    std::vector<float> values;    ///< of the thumbnail, top row first
    double low = 0.0, high = 0.0; ///< least and largest value of the frame
};

/// What came of it.
struct SimulationOutcome {
    SimulationOrder order;
    SimulationResult result;
    std::vector<WrittenFrame> frames;
    std::vector<FilmStrip> films;   ///< none where the values of frames were not written
    std::vector<std::string> notes; ///< about the folders
};

/// Frames that are to become a film.
struct FilmOrder {
    FilmStrip strip;
    std::filesystem::path file;
    std::string whose; ///< the file that errors about the settings name
};
struct FilmOutcome {
    std::filesystem::path file;
    std::string sentence; ///< why there is no film; empty where there is one
};

/// Writes all that an order asks for, as smat-batch simulate does. Throws irsg::InputError.
SimulationOutcome runSimulationOrder(const SimulationOrder& order, SceneBuilder& scenes,
                                     const RenderDoor& door, const ProgressCallback& progress,
                                     std::stop_token stop);

} // namespace smat::gui
