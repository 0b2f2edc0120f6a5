#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "smatcore/project/Project.h"

namespace smat {

/// The files that a file names and that are there: by names in quotation marks, between tags or at
/// the ends of lines, seen from its folder, and by names of files in its folder or below that occur
/// in its bytes. So the textures, materials, buffers and external references of a model, the parts
/// of an Environment and the tables of an atmosphere are found. The names in an .osgb or .ive may
/// be packed: all pictures in its folder and below count as named.
std::vector<std::filesystem::path> filesNamedBy(const std::filesystem::path& file);

/// Copies of files in one folder, each with all that it names in turn; what they name by way of
/// folders lies there in the same way. Nothing is copied before write().
class FileCollection {
  public:
    /// `folder`: where the copies will lie.
    explicit FileCollection(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Where the copy of a file or of a folder of files will lie, below the folder `kind`
    /// ("models"); with `beside`, files that lie beside it. The same file has one copy. A file that
    /// is missing is noted.
    std::filesystem::path add(const std::filesystem::path& file, const std::string& kind,
                              const std::vector<std::filesystem::path>& beside = {});
    /// Text of settings with the copies of their files in the place of these. `resolve` gives what
    /// a path means.
    template <typename Resolve>
    Settings collected(Settings settings, Resolve resolve);

    /// From, to.
    const std::map<std::filesystem::path, std::filesystem::path>& copies() const { return copies_; }
    std::size_t size_B() const;
    /// Throws InputError that names every file that is missing, or one that cannot be written;
    /// files that are there already with other bytes are refused.
    void write() const;

  private:
    void addPath(Settings& settings, const std::string& key,
                 const std::vector<std::filesystem::path>& files);

    std::filesystem::path folder_;
    std::map<std::filesystem::path, std::filesystem::path> copies_;
    std::set<std::filesystem::path> taken_; ///< folders of copies
    std::vector<std::string> missing_;
};

/// A project as it is once its files were copied beside it: into the folder `NAME.files` beside
/// `file`. Without its results.
Project collectedProject(const Project& project, const std::filesystem::path& file,
                         FileCollection& files);

/// Copies a project with all files that it needs to a new place, and returns it. Throws InputError
/// as FileCollection::write and saveProject do.
Project collectProject(const Project& project, const std::filesystem::path& file,
                       FileCollection* told = nullptr);

/// Whether a project needs files that lie outside of a folder (absolute, in normal form).
bool refersElsewhere(const Project& project, const std::filesystem::path& folder);

/// The codes and scalings that lie beside a model.
std::vector<std::filesystem::path> filesBesideModel(const std::filesystem::path& model);

/// "NAME.files" beside a document.
std::filesystem::path collectionFolder(const std::filesystem::path& document);

template <typename Resolve>
Settings FileCollection::collected(Settings settings, Resolve resolve) {
    for (const SettingInfo& setting : settingTable()) {
        if ((setting.kind != SettingKind::path && setting.kind != SettingKind::pathList) ||
            !settings.isSet(setting.key))
            continue;
        std::vector<std::filesystem::path> files;
        for (const std::filesystem::path& path : settings[PathsKey{setting.key.c_str()}])
            files.push_back(resolve(path));
        addPath(settings, setting.key, files);
    }
    return settings;
}

} // namespace smat
