#include "gui/start/DataFolder.h"

#include <array>
#include <cstdlib>

#include <QCoreApplication>
#include <QStandardPaths>

#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

struct Named {
    const char *folder, *title, *words;
    const char* extension = ".smat"; ///< of the file that is opened
};
constexpr std::array known{
    Named{"heron", QT_TRANSLATE_NOOP("Samples", "Patrol aircraft"),
          QT_TRANSLATE_NOOP("Samples", "A twin turboprop low over the sea")},
    Named{"tern", QT_TRANSLATE_NOOP("Samples", "Twin jet"),
          QT_TRANSLATE_NOOP("Samples", "Two engines with and without reheat, their gas in zones")},
    Named{"corvette", QT_TRANSLATE_NOOP("Samples", "Corvette"),
          QT_TRANSLATE_NOOP("Samples", "A warship with hot funnels and their plumes")},
    Named{"turboprop4", QT_TRANSLATE_NOOP("Samples", "Transport aircraft"),
          QT_TRANSLATE_NOOP("Samples", "The aircraft of the guide's first page")},
    Named{"valley", QT_TRANSLATE_NOOP("Samples", "Over a valley"),
          QT_TRANSLATE_NOOP("Samples", "Sky, terrain and sun in one picture")},
    Named{"ship", QT_TRANSLATE_NOOP("Samples", "Ship"),
          QT_TRANSLATE_NOOP("Samples", "A day at sea: night, noon and two crossovers")},
    Named{"flyby", QT_TRANSLATE_NOOP("Samples", "Fly-by"),
          QT_TRANSLATE_NOOP("Samples", "A scenario: two aircraft seen by two sensors over time"),
          ".json"},
    Named{"sphere", QT_TRANSLATE_NOOP("Samples", "Sphere"),
          QT_TRANSLATE_NOOP("Samples", "Every number has a closed form")},
};

bool isFolder(const std::filesystem::path& path) {
    std::error_code failure;
    return std::filesystem::is_directory(path, failure);
}

/// The file below the samples; empty for any other.
std::filesystem::path insideSamples(const std::filesystem::path& file) {
    const auto folder = dataFolder("samples");
    if (folder.empty() || file.empty())
        return {};
    std::error_code failure;
    const auto inside = std::filesystem::weakly_canonical(file, failure)
                            .lexically_relative(std::filesystem::canonical(folder, failure));
    return failure || inside.empty() || *inside.begin() == ".." ? std::filesystem::path() : inside;
}

} // namespace

std::filesystem::path dataFolder(const std::filesystem::path& name) {
    std::vector<std::filesystem::path> roots;
    if (const char* given = std::getenv("SMAT_DATA"); given != nullptr && *given != '\0')
        roots.emplace_back(given);
    const std::filesystem::path program = QCoreApplication::applicationDirPath().toStdString();
    roots.push_back(program / "../share/smat");
    roots.push_back(program / "../../.."); // build/PRESET/bin
    for (const auto& root : roots)
        if (isFolder(root / name))
            return (root / name).lexically_normal();
    return {};
}

std::vector<Sample> samples() {
    const std::filesystem::path folder = dataFolder("samples");
    std::vector<Sample> list;
    for (const Named& one : known) {
        const std::filesystem::path own = folder / one.folder;
        const std::filesystem::path project = own / (std::string(one.folder) + one.extension);
        std::error_code failure;
        if (!folder.empty() && std::filesystem::exists(project, failure))
            list.push_back({QCoreApplication::translate("Samples", one.title),
                            QCoreApplication::translate("Samples", one.words), project,
                            own / "picture.png"});
    }
    return list;
}

bool isOfSample(const std::filesystem::path& file) {
    return !insideSamples(file).empty();
}

void requireOwnPlace(const std::filesystem::path& file) {
    if (isOfSample(file))
        throw irsg::InputError({file.string(), "",
                                "one that belongs to the samples of this program",
                                "a file in a folder of your own"});
}

std::filesystem::path ownPlaceOf(const std::filesystem::path& file) {
    if (!isOfSample(file))
        return file;
    const QString own = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return std::filesystem::path(own.toStdString()) / file.filename();
}

std::filesystem::path placeForUnsaved(const std::filesystem::path& file,
                                      const std::filesystem::path& unnamed) {
    const auto inside = insideSamples(file);
    if (inside.empty() && !file.empty())
        return file;
    const QString data = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    const std::filesystem::path own = std::filesystem::path(data.toStdString()) / "smat";
    const auto place = file.empty() ? own / unnamed : own / "samples" / inside;
    // Where it cannot be made, keeping the copy says so.
    std::error_code failure;
    std::filesystem::create_directories(place.parent_path(), failure);
    return place;
}

} // namespace smat::gui
