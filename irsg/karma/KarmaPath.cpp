#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "irsg/core/WrittenPath.h"
#include "irsg/karma/KarmaXml.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

/// The text behind $(KARMA_ROOT) or %KARMA_ROOT%; false where the path does not begin with either.
bool takeRoot(std::string& path) {
    for (const std::string_view root : {"$(KARMA_ROOT)", "%KARMA_ROOT%"})
        if (path.starts_with(root)) {
            path.erase(0, root.size());
            path.erase(0, std::min(path.find_first_not_of('/'), path.size()));
            return true;
        }
    return false;
}

} // namespace

fs::path resolveKarmaPath(const std::string& path, const fs::path& file,
                          const std::string& position) {
    std::string rest = path;
    std::ranges::replace(rest, '\\', '/');
    const bool fromRoot = takeRoot(rest);
    const char* const named = std::getenv("KARMA_ROOT");
    const bool hasRoot = named != nullptr && *named != '\0';
    std::string root = hasRoot ? named : "";
    std::ranges::replace(root, '\\', '/');

    const fs::path folder = file.parent_path();
    const std::vector<fs::path> places = {fromRoot && hasRoot ? fs::path(root) / rest
                                                              : folder / rest,
                                          folder / fs::path(rest).filename()};
    std::error_code ignored;
    std::string searched;
    for (const fs::path& place : places) {
        if (const fs::path found = findWritten({}, place.string()).file;
            fs::is_regular_file(found, ignored))
            return found;
        const std::string shown = place.lexically_normal().string();
        if (searched.find(shown) == std::string::npos)
            searched += (searched.empty() ? "" : ", ") + shown;
    }
    throw InputError(
        {file.string(), position, "'" + path + "'",
         "a file that is there (searched: " + searched +
             (fromRoot && !hasRoot ? "; the environment variable KARMA_ROOT is not set" : "") +
             ")"});
}

} // namespace irsg
