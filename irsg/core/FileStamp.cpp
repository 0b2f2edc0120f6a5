#include "irsg/core/FileStamp.h"

namespace irsg {

std::string FileStamp::text() const {
    return std::to_string(written.time_since_epoch().count()) + "|" + std::to_string(size_B);
}

std::optional<FileStamp> stampOf(const std::filesystem::path& file) {
    std::error_code failure;
    const bool regular = std::filesystem::is_regular_file(file, failure);
    const auto written = std::filesystem::last_write_time(file, failure);
    if (!regular || failure)
        return std::nullopt;
    const std::uintmax_t size_B = std::filesystem::file_size(file, failure);
    return failure ? std::nullopt : std::optional(FileStamp{written, size_B});
}

} // namespace irsg
