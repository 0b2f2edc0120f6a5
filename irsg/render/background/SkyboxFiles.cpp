#include <algorithm>
#include <string>

#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/render/background/Skybox.h"

namespace irsg {

namespace fs = std::filesystem;

namespace {

bool isPicture(const fs::path& file) {
    return !refusalOf(file.string(), FileKind::picture);
}

} // namespace

std::shared_ptr<const Skybox> Skybox::load(const fs::path& folder) {
    return load(filesIn(folder));
}

std::array<fs::path, 6> Skybox::filesIn(const fs::path& folder) {
    std::error_code failed;
    std::vector<fs::path> pictures;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed))
        if (isPicture(entry->path()))
            pictures.push_back(entry->path());
    if (failed)
        throw InputError({folder.string(), "", failed.message(),
                          "a folder with six pictures north, south, east, west, up and down"});

    std::array<fs::path, 6> files;
    std::vector<Diagnostic> diagnostics;
    for (std::size_t face = 0; face < 6; ++face) {
        const std::string name = faceNames[face];
        std::vector<fs::path> found;
        for (const fs::path& picture : pictures) {
            const std::string stem = lowerCase(picture.stem().string());
            if (stem == name || stem == name.substr(0, 1))
                found.push_back(picture);
        }
        std::ranges::sort(found);
        if (found.empty())
            diagnostics.push_back({folder.string(), "skybox face " + name, "no picture",
                                   name + ".png or another picture of that name"});
        else if (found.size() > 1)
            diagnostics.push_back(
                {folder.string(), "skybox face " + name,
                 found[0].filename().string() + " and " + found[1].filename().string(),
                 "one picture"});
        else
            files[face] = found[0];
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return files;
}

std::shared_ptr<const Skybox> Skybox::load(const std::array<fs::path, 6>& files) {
    std::array<TextureImage, 6> faces;
    std::array<std::string, 6> names;
    std::vector<Diagnostic> diagnostics;
    for (std::size_t face = 0; face < 6; ++face) {
        names[face] = files[face].string();
        if (files[face].empty()) {
            diagnostics.push_back({"skybox", "face " + std::string(faceNames[face]), "no file",
                                   "the file of its picture"});
            continue;
        }
        collect(
            diagnostics, [&] { faces[face] = readTexture(files[face]); },
            [&](Diagnostic& one) {
                one.position = "skybox face " + std::string(faceNames[face]) +
                               (one.position.empty() ? "" : ", " + one.position);
            });
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return std::make_shared<const Skybox>(std::move(faces), names);
}

} // namespace irsg
