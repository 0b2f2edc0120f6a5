#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "smatcore/simulate/FrameFiles.h"

namespace smat {

/// Where the frames of a run are written: into the folder of their sensor, or into SENSOR.partial
/// beside it while the whole result of an earlier run stands there, so that a run that is stopped
/// or killed leaves that as it was.
class FramePlaces {
  public:
    /// Takes the frames of stopped runs out of SENSOR.partial. The files must outlive it. Throws
    /// InputError where a folder cannot be made.
    FramePlaces(const FrameFiles& files, const std::vector<std::size_t>& sensors);

    std::filesystem::path folder(std::size_t sensor) const { return folders_.at(sensor); }
    /// Of a run that is whole: moves its frames in the place of those before, one by one. Throws
    /// InputError where that fails.
    void moveIn();

  private:
    const FrameFiles& files_;
    std::map<std::size_t, std::filesystem::path> folders_;
};

} // namespace smat
