#include "irsg/core/WrittenPath.h"

#include <algorithm>
#include <system_error>

namespace irsg {

namespace {

namespace fs = std::filesystem;

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string withSlashes(std::string written) {
    std::ranges::replace(written, '\\', '/');
    return written;
}

bool isThere(const fs::path& path) {
    std::error_code failure;
    return fs::exists(path, failure);
}

/// The one entry of a folder that has the name but for its case; empty where none or several do.
fs::path likeIn(const fs::path& folder, const std::string& name) {
    fs::path found;
    std::error_code failure;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, failure), end;
         !failure && entry != end; entry.increment(failure)) {
        const std::string own = entry->path().filename().string();
        if (!isSameName(own, name))
            continue;
        if (!found.empty())
            return {};
        found = folder / own;
    }
    return found;
}

/// Goes down name by name.
fs::path withAnyCase(const fs::path& path) {
    fs::path place;
    for (const fs::path& name : path) {
        const fs::path next = place / name;
        place = isThere(next) ? next : likeIn(place, name.string());
        if (place.empty())
            return {};
    }
    return place;
}

} // namespace

WrittenPath findWritten(const fs::path& folder, const std::string& written) {
    if (written.empty())
        return {};
    if (const fs::path plain = folder / written; isThere(plain))
        return {plain, ""};
    const fs::path turned = withSlashes(written);
    const fs::path whole = folder / turned;
    const fs::path found = isThere(whole) ? whole : withAnyCase(whole);
    if (found.empty())
        return {};
    const fs::path shown =
        fs::path(turned).is_absolute() || folder.empty()
            ? found
            : found.lexically_normal().lexically_relative(folder.lexically_normal());
    return {found,
            "the name " + written + " is read as " + (shown.empty() ? found : shown).string()};
}

std::string writtenFileName(const std::string& written) {
    return fs::path(withSlashes(written)).filename().string();
}

bool isSameName(const std::string& one, const std::string& other) {
    return std::ranges::equal(one, other, [](char a, char b) { return lower(a) == lower(b); });
}

} // namespace irsg
