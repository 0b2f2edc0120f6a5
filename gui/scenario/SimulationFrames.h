#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/image/RadianceImage.h"
#include "smatcore/jobs/AnalysisJobs.h"

namespace smat::gui {

/// A frame that was written, small enough to be kept and shown in a row of all.
struct WrittenFrame {
    std::size_t sensor = 0, band = 0, number = 0;
    double time_s = 0.0;
    int width = 0, height = 0;    ///< of the thumbnail
    std::vector<float> values;    ///< of the thumbnail, top row first
    double low = 0.0, high = 0.0; ///< least and largest value of the frame
};

/// What came of it.
struct SimulationFrames {
    SimulationJob order;
    SimulationResult result = {};
    std::vector<WrittenFrame> frames = {};
    std::vector<FilmStrip> films = {};   ///< none where the values of frames were not written
    std::vector<std::string> notes = {}; ///< about the folders
};

/// Frames that are to become a film.
struct FilmOrder {
    FilmStrip strip;
    std::filesystem::path file;
    std::string whose; ///< the file that errors about the settings name
};
struct FilmOutcome {
    std::vector<std::filesystem::path> files; ///< one, or numbered pictures
    std::string sentence;                     ///< why there is no film; empty where there is one
};

/// Writes all that a job asks for, as smat-batch simulate does. Throws irsg::InputError.
SimulationFrames runSimulation(const SimulationJob& job, JobRunner& runner,
                               const JobControl& control);

} // namespace smat::gui
