#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/analysis/ImageFiles.h"
#include "smatcore/simulate/Simulation.h"

namespace smat {

/// How what a sensor of a scenario sees came to be: program, command where it is not empty,
/// scenario, entities, bands, settings and what was drawn of scaling files.
Provenance sensorProvenance(const LoadedScenario& scenario, std::size_t sensor,
                            const std::string& commandLine);

/// Where the frames of a simulation go: one folder a sensor, `frame_000012.exr` in it, a table
/// `SENSOR.csv` beside it, and `SENSOR.xml`, its settings as an ImagingSensor file. Files say how
/// they came to be and hold no clock: equal inputs give equal bytes.
class FrameFiles {
  public:
    /// `extensions` as in irsg::imageExtensions. `commandLine` goes into the provenance where it is
    /// not empty.
    FrameFiles(const LoadedScenario& scenario, std::filesystem::path folder,
               std::vector<std::string> extensions, std::string commandLine);

    /// Throws InputError for extensions that no image has.
    void checkExtensions() const;
    /// Makes the folders of these sensors. Throws InputError where none can be made. Returns a
    /// sentence for each that already holds frames.
    std::vector<std::string> makeFolders(const std::vector<std::size_t>& sensors) const;

    /// Throws InputError with all that makeFolders() and the tables could not write. Changes
    /// nothing.
    void checkOutputs(const std::vector<std::size_t>& sensors) const;

    /// "frame_000012.exr", of one of several bands "frame_000012@3-5um.exr".
    std::filesystem::path frameFile(std::size_t sensor, std::size_t number,
                                    const std::string& extension, std::size_t band = 0) const;
    /// The same in every form, in the order in which they are written.
    std::vector<std::filesystem::path> framesOf(std::size_t sensor, std::size_t number,
                                                std::size_t band) const;
    /// Of the frames of a sensor; the name of a sensor is one.
    std::filesystem::path frameFolder(std::size_t sensor) const;
    /// By its name.
    static bool isFrame(const std::filesystem::path& file);
    std::filesystem::path tableFile(std::size_t sensor) const;
    std::filesystem::path imagingSensorFile(std::size_t sensor) const;

    /// Describes the image of a frame (time, sensor, places of the entities, settings), and makes
    /// of it what `image.quantity` asks for: what stands in its file.
    void describe(SensorFrame& frame, std::size_t number) const;
    /// Describes a frame and writes it in every form, into the folder of its sensor where none is
    /// given. Throws InputError.
    void write(SensorFrame& frame, std::size_t number,
               const std::filesystem::path& folder = {}) const;
    /// What stands above the picture of a frame.
    PictureWords words(std::size_t sensor, double time_s) const;
    /// Writes what the frames of a sensor are made with in KARMA's form into `file`, or
    /// imagingSensorFile() where that is empty, on top of what else its own ImagingSensor file
    /// holds. Throws InputError.
    void writeImagingSensor(std::size_t sensor, const std::filesystem::path& file = {}) const;
    /// What the table of a sensor says of itself.
    Provenance provenanceOf(const SensorResult& result, AnalysisState state) const;
    /// Writes the table of a sensor with its provenance, one that is not complete beside that of a
    /// run that was (placeOfPartial). Throws InputError.
    void writeTable(SensorResult& result, AnalysisState state) const;

  private:
    const LoadedScenario& scenario_;
    std::filesystem::path folder_;
    std::vector<std::string> extensions_;
    std::string commandLine_;
};

/// The steps of a run in parts: a store for each sensor of the plan.
struct SimulationParts {
    std::vector<CaseStore*> stores;
    bool isPart = false; ///< of several, which are joined to the tables: none is written
};

/// Makes the frames of a plan with this renderer and writes all there is to write: folders,
/// frames, and ImagingSensor files and tables at the end, however it ends. A run that does not come
/// to its end leaves the whole result of an earlier one as it was (FramePlaces, placeOfPartial),
/// but for one in parts, whose frames go where they stay. `heed` is given each frame after it was
/// written. Throws InputError, and then the tables hold what was done before.
void writeSimulation(const LoadedScenario& scenario, const SimulationPlan& plan,
                     const FrameFiles& files, const RenderDoor& door, SimulationResult& result,
                     const ProgressCallback& progress = {}, std::stop_token stop = {},
                     StageTimer* timer = nullptr, const FrameSink& heed = {},
                     const SimulationParts* parts = nullptr);

} // namespace smat
