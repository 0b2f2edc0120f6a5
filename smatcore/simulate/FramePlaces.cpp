#include "smatcore/simulate/FramePlaces.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "irsg/core/Errors.h"
#include "smatcore/support/Folders.h"
#include "smatcore/support/PartialFile.h"

namespace smat {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> framesIn(const fs::path& folder) {
    std::vector<fs::path> frames;
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure))
        if (FrameFiles::isFrame(entry.path()))
            frames.push_back(entry.path());
    std::ranges::sort(frames);
    return frames;
}

void clear(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::path& frame : framesIn(folder))
        fs::remove(frame, ignored);
    fs::remove(folder, ignored); // stays where it holds anything else
}

} // namespace

FramePlaces::FramePlaces(const FrameFiles& files, const std::vector<std::size_t>& sensors)
    : files_(files) {
    for (const std::size_t sensor : sensors) {
        const fs::path own = files.frameFolder(sensor), beside = partialFileBeside(own);
        const fs::path table = files.tableFile(sensor);
        clear(beside);
        const bool isWhole = fs::exists(table) && !isPartialResult(table);
        folders_[sensor] = isWhole && !framesIn(own).empty() ? beside : own;
        makeFolder(folders_[sensor], "frames");
    }
}

void FramePlaces::moveIn() {
    for (auto& [sensor, folder] : folders_) {
        const fs::path own = files_.frameFolder(sensor);
        if (folder == own)
            continue;
        for (const fs::path& frame : framesIn(folder)) {
            std::error_code failure;
            fs::rename(frame, own / frame.filename(), failure);
            if (failure)
                throw irsg::InputError(
                    {.file = (own / frame.filename()).string(),
                     .position = "",
                     .value = failure.message(),
                     .expected =
                         "a file that may be replaced; the frames are in " + folder.string()});
        }
        clear(std::exchange(folder, own));
    }
}

} // namespace smat
