#include "irsg/geometry/reading/sandbox/NamedFiles.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <system_error>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Wording.h"
#include "irsg/core/WrittenPath.h"
#include "irsg/geometry/reading/OpenableFiles.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestName = 1024, mostNames = 4096;
/// Names stand at the beginning of large files, or among few numbers.
constexpr std::size_t mostText_B = std::size_t{256} << 20;
constexpr std::size_t mostLibraries = 64, mostLibrary_B = std::size_t{4} << 20;

constexpr FileKind kinds[] = {FileKind::model, FileKind::picture, FileKind::attributes,
                              FileKind::materials, FileKind::buffers};

/// What no name goes on over.
bool isEnd(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\'' || c == '<' || c == '>' ||
           c == '|' || c == '*' || c == '?';
}

bool isBegin(std::string_view text, std::size_t at) {
    return at == 0 || text[at - 1] == ' ' || text[at - 1] == '=' || isEnd(text[at - 1]);
}

/// The file that a name at the beginning of a text means, which may go on behind it.
fs::path fileOf(std::string_view text, const fs::path& folder) {
    const std::size_t end = static_cast<std::size_t>(
        std::ranges::find_if(text.substr(0, longestName), isEnd) - text.begin());
    const std::string whole(text.substr(0, end));
    const std::string lower = lowerCase(whole);
    std::error_code failure;
    for (std::size_t dot = lower.find('.', 2); dot != lower.npos; dot = lower.find('.', dot + 1))
        for (const FileKind kind : kinds)
            for (const FileFormat& format : formatsOf(kind)) {
                if (!lower.substr(dot + 1).starts_with(format.extension))
                    continue;
                const std::size_t length = dot + 1 + std::string_view(format.extension).size();
                const fs::path file = findWritten(folder, whole.substr(0, length)).file;
                if (fs::is_regular_file(file, failure))
                    return file;
            }
    return {};
}

std::string beginningOf(const fs::path& file, std::size_t most_B) {
    try {
        return readFileBeginning(file, most_B);
    } catch (const InputError&) {
        return {};
    }
}

void add(std::vector<fs::path>& files, const std::vector<fs::path>& more) {
    for (const fs::path& file : more)
        if (std::ranges::find(files, file) == files.end())
            files.push_back(file);
}

} // namespace

std::vector<fs::path> filesNamedIn(std::string_view text, const fs::path& folder) {
    std::vector<fs::path> files;
    std::size_t looked = 0;
    const auto look = [&](std::size_t at) {
        if (++looked > mostNames)
            return;
        if (const fs::path file = fileOf(text.substr(at), folder); !file.empty())
            add(files, {file});
    };
    for (const char slash : {'/', '\\'})
        for (std::size_t at = text.find(slash); at != text.npos; at = text.find(slash, at + 1)) {
            const bool isUp = at >= 2 && text[at - 1] == '.' && text[at - 2] == '.';
            if (isUp && (at < 3 || (text[at - 3] != '/' && text[at - 3] != '\\')))
                look(at - 2);
            else if (slash == '/' && at + 1 < text.size() && text[at + 1] != '/' &&
                     isBegin(text, at))
                look(at);
        }
    return files;
}

std::vector<fs::path> filesNamedOutside(const fs::path& place, const fs::path& model) {
    const fs::path folder = model.parent_path();
    std::vector<fs::path> files = filesNamedIn(beginningOf(place, mostText_B), folder);
    std::size_t libraries = 0;
    std::error_code failure;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, failure), end;
         !failure && entry != end && libraries < mostLibraries; entry.increment(failure)) {
        if (refusalOf(entry->path().filename().string(), FileKind::materials))
            continue;
        ++libraries;
        add(files, filesNamedIn(beginningOf(entry->path(), mostLibrary_B), folder));
    }
    return files;
}

} // namespace irsg
