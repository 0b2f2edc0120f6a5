#include "smatcore/project/FileCollection.h"

#include <algorithm>
#include <string_view>
#include <system_error>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/Wording.h"
#include "irsg/core/WrittenPath.h"
#include "irsg/geometry/reading/ModelCodes.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/signature/ScalingXml.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/project/ProjectFile.h"

namespace smat {

namespace {

namespace fs = std::filesystem;

/// Names stand at the beginning of large files, or among few numbers.
constexpr std::size_t mostText_B = std::size_t{64} << 20;
constexpr std::size_t shortestName = 4, longestName = 1024, mostBeside = 4096, mostDepth = 8;

bool isFile(const fs::path& file) {
    std::error_code failure;
    return fs::is_regular_file(file, failure);
}
bool isFolder(const fs::path& file) {
    std::error_code failure;
    return fs::is_directory(file, failure);
}

std::string beginningOf(const fs::path& file) {
    try {
        return irsg::readFileBeginning(file, mostText_B);
    } catch (const irsg::InputError&) {
        return {}; // what cannot be read names nothing
    }
}

/// The file that a text names as a whole.
fs::path fileNamed(std::string_view text, const fs::path& folder) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    if (text.size() < 3 || text.size() > longestName || text.find('.') == text.npos)
        return {};
    const fs::path file = irsg::findWritten(folder, std::string(text)).file;
    return isFile(file) ? file.lexically_normal() : fs::path();
}

/// The files below a folder, as far as a model may have them there.
std::vector<fs::path> filesBelow(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failure;
    const fs::path start = folder.empty() ? fs::path(".") : folder;
    for (fs::recursive_directory_iterator
             entry(start, fs::directory_options::skip_permission_denied, failure),
         end;
         !failure && entry != end && files.size() < mostBeside; entry.increment(failure)) {
        if (entry.depth() >= 3)
            entry.disable_recursion_pending();
        if (isFile(entry->path()))
            files.push_back(entry->path().lexically_normal());
    }
    std::ranges::sort(files);
    return files;
}

/// Whether the names in a model may be packed with its numbers.
bool isPacked(const fs::path& model) {
    const std::string extension = irsg::lowerCase(model.extension().string());
    return extension == ".osgb" || extension == ".ive";
}

/// The deepest folder that all lie in.
fs::path commonFolder(const std::vector<fs::path>& files) {
    fs::path common = files.front().parent_path();
    const auto isIn = [](const fs::path& file, const fs::path& folder) {
        return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
               folder.end();
    };
    for (const fs::path& file : files)
        while (!isIn(file, common) && common.has_relative_path())
            common = common.parent_path();
    return common;
}

fs::path normalised(const fs::path& file) {
    return fs::absolute(file).lexically_normal();
}

} // namespace

std::vector<fs::path> filesNamedBy(const fs::path& file) {
    const std::string bytes = beginningOf(file);
    const fs::path folder = file.parent_path();
    std::vector<fs::path> files;
    const auto add = [&](const fs::path& one) {
        if (!one.empty() && one != file.lexically_normal() &&
            std::ranges::find(files, one) == files.end())
            files.push_back(one);
    };
    constexpr std::string_view ends("\"'<>\n\0;", 7);
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = std::min(bytes.find_first_of(ends, at), bytes.size());
        const std::string_view token(bytes.data() + at, end - at);
        add(fileNamed(token, folder));
        if (const std::size_t blank = token.rfind(' '); blank != token.npos)
            add(fileNamed(token.substr(blank), folder));
        at = end + 1;
    }
    const std::string lower = irsg::lowerCase(bytes);
    for (const fs::path& beside : filesBelow(folder)) {
        const std::string name = irsg::lowerCase(beside.filename().string());
        const bool isNamed = name.size() >= shortestName && name.find('.', 1) != name.npos &&
                             lower.find(name) != lower.npos;
        if (isNamed || (isPacked(file) && !irsg::refusalOf(name, irsg::FileKind::picture)))
            add(beside);
    }
    return files;
}

fs::path FileCollection::add(const fs::path& given, const std::string& kind,
                             const std::vector<fs::path>& beside) {
    const fs::path file = normalised(given);
    if (const auto known = copies_.find(file); known != copies_.end())
        return known->second;
    if (!isFile(file) && !isFolder(file)) {
        missing_.push_back(given.string());
        return file;
    }
    std::vector<fs::path> group;
    if (isFolder(file)) {
        for (const auto& entry : fs::directory_iterator(file))
            if (isFile(entry.path()))
                group.push_back(entry.path());
        std::ranges::sort(group);
    } else {
        group.push_back(file);
        for (const fs::path& one : beside)
            group.push_back(normalised(one));
        // What is named by what is named.
        std::size_t looked = 0;
        for (std::size_t depth = 0; depth < mostDepth && looked < group.size(); ++depth)
            for (const std::size_t end = group.size(); looked < end; ++looked)
                for (const fs::path& one : filesNamedBy(group[looked]))
                    if (std::ranges::find(group, normalised(one)) == group.end())
                        group.push_back(normalised(one));
    }
    const fs::path from = isFolder(file) ? file : commonFolder(group);
    fs::path to = folder_ / kind / file.stem();
    for (int number = 2; taken_.contains(to); ++number)
        to = folder_ / kind / (file.stem().string() + "-" + std::to_string(number));
    taken_.insert(to);
    for (const fs::path& one : group)
        copies_.emplace(one, to / one.lexically_relative(from));
    if (isFolder(file)) {
        copies_.emplace(file, to); // the folder itself, whose files are copied
        return to;
    }
    return copies_.at(file);
}

void FileCollection::addPath(Settings& settings, const std::string& key,
                             const std::vector<fs::path>& files) {
    const std::string kind = key == "environment.atmospheres" ? "atmospheres"
                             : key.starts_with("image.")      ? "sensors"
                                                              : "data";
    std::string text;
    for (const fs::path& file : files) {
        const fs::path copy = isNoAtmosphere(file) ? file : add(file, kind);
        text += (text.empty() ? "" : ";") + copy.string();
    }
    settings.set(key, text);
}

std::size_t FileCollection::size_B() const {
    std::size_t sum = 0;
    for (const auto& [from, to] : copies_)
        if (isFile(from))
            sum += static_cast<std::size_t>(fs::file_size(from));
    return sum;
}

void FileCollection::write() const {
    std::vector<irsg::Diagnostic> diagnostics;
    for (const std::string& file : missing_)
        diagnostics.push_back({"", "", file, "a file that exists"});
    const auto bytesOf = [](const fs::path& file) { return irsg::readFile(file); };
    for (const auto& [from, to] : copies_)
        if (isFile(to) && !fs::equivalent(from, to) && bytesOf(to) != bytesOf(from))
            diagnostics.push_back(
                {to.string(), "", "another file of that name", "a place without such files"});
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    for (const auto& [from, to] : copies_) {
        std::error_code failure;
        if (isFolder(from) || (isFile(to) && fs::equivalent(from, to)))
            continue;
        fs::create_directories(to.parent_path(), failure);
        irsg::writeFileDurably(to, bytesOf(from));
    }
}

fs::path collectionFolder(const fs::path& document) {
    return normalised(document).parent_path() / (document.stem().string() + ".files");
}

bool refersElsewhere(const Project& project, const fs::path& folder) {
    FileCollection files(folder);
    (void)collectedProject(project, folder / "copy.smat", files);
    return std::ranges::any_of(files.copies(), [&](const auto& copy) {
        return commonFolder({copy.first, folder / "copy.smat"}) != folder;
    });
}

std::vector<fs::path> filesBesideModel(const fs::path& model) {
    std::vector<fs::path> beside;
    for (const fs::path& one :
         {irsg::codesFileOf(model), irsg::scalingFile(model, irsg::ScalingKind::temperature),
          irsg::scalingFile(model, irsg::ScalingKind::emissivity)})
        if (isFile(one))
            beside.push_back(one);
    return beside;
}

Project collectedProject(const Project& project, const fs::path& file, FileCollection& files) {
    Project made = project;
    made.file = normalised(file);
    made.results.clear();
    const auto resolve = [&project](const fs::path& path) { return project.resolve(path); };
    for (ProjectModel& model : made.models) {
        const fs::path from = resolve(model.file);
        model.file = files.add(from, "models", filesBesideModel(from));
        if (!model.database.empty())
            model.database = files.add(resolve(model.database), "databases");
    }
    made.settings = files.collected(made.settings, resolve);
    for (NamedAnalysis& analysis : made.analyses)
        analysis.settings = files.collected(analysis.settings, resolve);
    return made;
}

Project collectProject(const Project& project, const fs::path& file, FileCollection* told) {
    FileCollection files(collectionFolder(file));
    const Project made = collectedProject(project, file, files);
    files.write();
    std::error_code failure;
    fs::create_directories(made.file.parent_path(), failure);
    saveProject(made, made.file);
    if (told != nullptr)
        *told = std::move(files);
    return loadProject(made.file);
}

} // namespace smat
