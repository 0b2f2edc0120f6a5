#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace irsg {

/// What tells whether a file has changed since it was looked at: the time of its last writing and
/// its size.
struct FileStamp {
    std::filesystem::file_time_type written;
    std::uintmax_t size_B = 0;

    /// For keys of caches: another text for another stamp.
    std::string text() const;
    bool operator==(const FileStamp&) const = default;
};

/// None where there is no regular file, or none that may be looked at.
std::optional<FileStamp> stampOf(const std::filesystem::path& file);

} // namespace irsg
