#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "smatcore/simulate/FrameFiles.h"

namespace smat {

/// The frames of one band of one sensor as they were written, in the order of their times.
struct FilmStrip {
    struct Frame {
        std::filesystem::path file; ///< with the values: OpenEXR
        std::size_t number = 0;
        PictureWords words;
    };
    std::size_t sensor = 0, band = 0;
    std::string label; ///< "mwir", of one of several bands "mwir@3-5um"
    Settings settings; ///< the colours are those of `display`
    double frames_per_s = 1.0;
    double low = 0.0, high = 0.0; ///< of all that is finite; low > high where nothing is
    std::vector<Frame> frames = {};
};

/// Collects the frames of a run for films; given to writeSimulation as what heeds its frames.
class FilmRecorder {
  public:
    /// Both must outlive it.
    FilmRecorder(const LoadedScenario& scenario, const FrameFiles& files);
    void heed(const SensorFrame& frame, std::size_t number);
    /// That of a sensor and a band before its first frame.
    static FilmStrip stripOf(const LoadedScenario& scenario, const FrameFiles& files,
                             std::size_t sensor, std::size_t band);
    const std::vector<FilmStrip>& strips() const { return strips_; }

  private:
    const LoadedScenario& scenario_;
    const FrameFiles& files_;
    std::vector<FilmStrip> strips_;
};

/// The first executable ffmpeg on PATH; none where there is none.
std::optional<std::filesystem::path> findFfmpeg();
/// Throws InputError for a file that is no film (.mp4, .gif, or .png for numbered pictures), and
/// for one that needs ffmpeg where there is none.
void checkFilm(const std::filesystem::path& file);
/// Throws InputError where no film of this name could be written: its folder, and the one for
/// temporary files that encoding needs. `file` is one of filmFiles(). Changes nothing.
void checkFilmPlace(const std::filesystem::path& file);
/// "pass.mp4", and "pass-mwir.mp4" where it is one of several.
std::filesystem::path filmFile(const std::filesystem::path& file, const FilmStrip& strip,
                               std::size_t strips);
/// What writeFilm writes into `file`: itself, or of a .png a numbered picture for each frame.
std::vector<std::filesystem::path> filmFiles(const std::filesystem::path& file,
                                             const FilmStrip& strip);
/// Writes the frames in one scale of colours: numbered pictures `FILE-000012.png` for .png, else a
/// film that ffmpeg encodes (.mp4 in H.264, or what it has instead; .gif), at as many frames a
/// second as the scenario has steps, from 1 to 50. `whose` is the file that errors about the
/// settings name. Returns the sentence that there is nothing to show, or "". Throws InputError; a
/// film is written whole or not at all. A stop leaves no film; of
/// numbered pictures those that are done stay. Progress counts frames, and encoding as one more.
std::string writeFilm(const FilmStrip& strip, const std::filesystem::path& file,
                      const std::string& whose, const std::stop_token& stop = {},
                      const ProgressCallback& progress = {});

} // namespace smat
