#include "smatcore/simulate/Film.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/ScratchFolder.h"
#include "irsg/image/ColorMap.h"
#include "irsg/image/ExrFile.h"
#include "smatcore/settings/SettingKeys.h"

extern char** environ; // NOLINT(readability-redundant-declaration)

namespace smat {

namespace {

namespace fs = std::filesystem;

constexpr double fewest_per_s = 1.0, most_per_s = 50.0;
constexpr const char* pictures = "the pictures that ffmpeg makes a film from";
constexpr auto betweenLooks = std::chrono::milliseconds(20);

irsg::InputError filmError(const fs::path& file, const std::string& value,
                           const std::string& expected) {
    return irsg::InputError(irsg::Diagnostic{
        .file = file.string(), .position = "", .value = value, .expected = expected});
}

/// Runs a program without a shell and without input; its errors go into a file. Its exit status, or
/// none where it was stopped.
std::optional<int> runProgram(const fs::path& program, std::vector<std::string> arguments,
                              const fs::path& errors, const std::stop_token& stop) {
    std::string name = program.string();
    std::vector<char*> words{name.data()};
    for (std::string& argument : arguments)
        words.push_back(argument.data());
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // A group of its own: Ctrl-C is for the program that asks.
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    pid_t process = -1;
    const int failure =
        posix_spawn(&process, name.c_str(), &actions, &attributes, words.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0)
        throw filmError(program, std::strerror(failure), "a program that can be started");
    int status = 0;
    while (waitpid(process, &status, WNOHANG) == 0) {
        if (stop.stop_requested()) {
            kill(process, SIGKILL);
            waitpid(process, &status, 0);
            return std::nullopt;
        }
        std::this_thread::sleep_for(betweenLooks);
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The last line that says something.
std::string lastLine(const fs::path& file) {
    std::istringstream text(irsg::readFile(file));
    std::string last;
    for (std::string line; std::getline(text, line);)
        if (!line.empty())
            last = line;
    return last;
}

/// Those of the display, in limits that hold for all frames.
Settings colorsOf(const FilmStrip& strip) {
    Settings settings = strip.settings;
    double low = strip.low, high = strip.high;
    if (irsg::ColorMap::named(settings.text(key::displayColorMap)).isDiverging()) {
        high = std::max(std::abs(low), std::abs(high));
        low = -high;
    }
    if (!(low < high))
        high = low + 1.0;
    if (!settings[key::displayMinimum])
        settings.set(key::displayMinimum, fmt::format("{}", low));
    if (!settings[key::displayMaximum])
        settings.set(key::displayMaximum, fmt::format("{}", high));
    return settings;
}

std::vector<std::string> ffmpegArguments(const FilmStrip& strip, const std::string& pictures,
                                         const fs::path& film) {
    // Players want H.264 in two-by-two pixels of colour; a GIF has its own palette.
    const bool isGif = film.extension() == ".gif";
    std::vector<std::string> arguments{"-nostdin",
                                       "-loglevel",
                                       "error",
                                       "-y",
                                       "-framerate",
                                       fmt::format("{:.6g}", strip.frames_per_s),
                                       "-i",
                                       pictures,
                                       "-vf",
                                       isGif ? "split[a][b];[a]palettegen[p];[b][p]paletteuse"
                                             : "pad=ceil(iw/2)*2:ceil(ih/2)*2"};
    if (!isGif)
        arguments.insert(arguments.end(), {"-pix_fmt", "yuv420p", "-movflags", "+faststart"});
    arguments.push_back(film.string());
    return arguments;
}

} // namespace

FilmRecorder::FilmRecorder(const LoadedScenario& scenario, const FrameFiles& files)
    : scenario_(scenario), files_(files) {}

FilmStrip FilmRecorder::stripOf(const LoadedScenario& scenario, const FrameFiles& files,
                                std::size_t sensor, std::size_t band) {
    const std::string stem = files.frameFile(sensor, 0, ".exr", band).stem().string();
    const std::size_t at = stem.find('@');
    return {.sensor = sensor,
            .band = band,
            .label = scenario.scenario.sensors.at(sensor).name +
                     (at == std::string::npos ? "" : stem.substr(at)),
            .settings = scenario.sensors.at(sensor).settings,
            .frames_per_s = std::clamp(1.0 / scenario.scenario.dt_s, fewest_per_s, most_per_s),
            .low = INFINITY,
            .high = -INFINITY};
}

void FilmRecorder::heed(const SensorFrame& frame, std::size_t number) {
    auto strip = std::ranges::find_if(strips_, [&](const FilmStrip& one) {
        return one.sensor == frame.sensor && one.band == frame.band;
    });
    const fs::path file = files_.frameFile(frame.sensor, number, ".exr", frame.band);
    if (strip == strips_.end()) {
        strips_.push_back(stripOf(scenario_, files_, frame.sensor, frame.band));
        strip = strips_.end() - 1;
    }
    for (const float value : frame.rendered.image.primary().values) {
        if (std::isfinite(value)) {
            strip->low = std::min(strip->low, static_cast<double>(value));
            strip->high = std::max(strip->high, static_cast<double>(value));
        }
    }
    strip->frames.push_back(
        {.file = file, .number = number, .words = files_.words(frame.sensor, frame.time_s)});
}

std::optional<fs::path> findFfmpeg() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path program = fs::path(folder) / "ffmpeg";
        std::error_code failure;
        if (!folder.empty() && fs::is_regular_file(program, failure) &&
            access(program.c_str(), X_OK) == 0)
            return program;
    }
    return std::nullopt;
}

void checkFilm(const fs::path& file) {
    const std::string extension = file.extension().string();
    if (extension != ".mp4" && extension != ".gif" && extension != ".png")
        throw filmError(file, extension.empty() ? "no extension" : extension,
                        "a film: .mp4, .gif, or .png for numbered pictures");
    if (extension != ".png" && !findFfmpeg())
        throw filmError(file, "no ffmpeg on PATH",
                        "the program ffmpeg (Debian's package ffmpeg), or .png for numbered "
                        "pictures");
}

void checkFilmPlace(const fs::path& file) {
    if (file.extension() != ".png") {
        irsg::scratchPlace(pictures);
        irsg::checkWritable(file);
        return;
    }
    irsg::checkWritable(file);
}

fs::path filmFile(const fs::path& file, const FilmStrip& strip, std::size_t strips) {
    if (strips < 2)
        return file;
    return file.parent_path() /
           (file.stem().string() + "-" + strip.label + file.extension().string());
}

std::vector<fs::path> filmFiles(const fs::path& file, const FilmStrip& strip) {
    if (file.extension() != ".png")
        return {file};
    std::vector<fs::path> pictures;
    pictures.reserve(strip.frames.size());
    for (const FilmStrip::Frame& frame : strip.frames)
        pictures.push_back(file.parent_path() /
                           fmt::format("{}-{:06}.png", file.stem().string(), frame.number));
    return pictures;
}

std::string writeFilm(const FilmStrip& strip, const fs::path& file, const std::string& whose,
                      const std::stop_token& stop, const ProgressCallback& progress) {
    checkFilm(file);
    if (strip.frames.empty() || strip.low > strip.high)
        return fmt::format("{}: no film, since no frame shows anything", strip.label);
    const Settings colors = colorsOf(strip);
    const bool isPictures = file.extension() == ".png";
    const std::vector<fs::path> numbered = filmFiles(file, strip);
    std::optional<irsg::ScratchFolder> temporary;
    if (!isPictures)
        temporary.emplace(pictures);
    std::size_t place = 0;
    const auto start = std::chrono::steady_clock::now();
    const auto say = [&](std::size_t done, std::string what) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        if (progress)
            progress({done, strip.frames.size() + (isPictures ? 0 : 1), elapsed.count(),
                      std::move(what)});
    };
    std::size_t done = 0;
    for (const FilmStrip::Frame& frame : strip.frames) {
        say(done, fmt::format("{}: frame {} of {}", strip.label, done + 1, strip.frames.size()));
        ++done;
        if (stop.stop_requested())
            return fmt::format("{}: no film, since it was stopped", strip.label);
        const fs::path picture =
            isPictures ? numbered.at(place) : *temporary / fmt::format("{:06}.png", place);
        ++place;
        saveImage(irsg::readExr(frame.file), colors, frame.words, whose, picture);
    }
    if (isPictures) {
        say(done, "done");
        return "";
    }
    say(done, strip.label + ": encoding");
    const fs::path film = *temporary / ("film" + file.extension().string());
    const fs::path errors = *temporary / "errors";
    const auto status =
        runProgram(findFfmpeg().value(),
                   ffmpegArguments(strip, (*temporary / "%06d.png").string(), film), errors, stop);
    if (!status)
        return fmt::format("{}: no film, since it was stopped", strip.label);
    if (*status != 0 || !fs::exists(film))
        throw filmError(file, fmt::format("ffmpeg ended with {}: {}", *status, lastLine(errors)),
                        "a film of the frames");
    irsg::writeFileDurably(file, irsg::readFile(film));
    say(done + 1, "done");
    return "";
}

} // namespace smat
