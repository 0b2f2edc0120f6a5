#include "irsg/image/FileBytes.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "irsg/radiometry/Errors.h"

namespace irsg {

namespace fs = std::filesystem;

namespace {

std::string systemReason(int error) {
    return error == 0 ? "unknown error" : std::generic_category().message(error);
}

void writeDirectly(const fs::path& file, std::string_view bytes, const fs::path& named) {
    errno = 0;
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (out)
        return;
    const int reason = errno;
    if (file != named) {
        std::error_code ignored;
        fs::remove(file, ignored);
    }
    throw InputError({named.string(), "", "cannot be written: " + systemReason(reason),
                      "a file in a folder that exists and can be written"});
}

} // namespace

std::string readFileBytes(const fs::path& file) {
    std::error_code unknown;
    if (fs::is_directory(file, unknown))
        throw InputError({file.string(), "", "a folder", "a file"});
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    if (in && in.peek() != std::ifstream::traits_type::eof())
        bytes << in.rdbuf();
    if (!in.is_open() || in.bad() || !bytes)
        throw InputError({file.string(), "", "cannot be read: " + systemReason(errno),
                          "a file that exists and can be read"});
    return std::move(bytes).str();
}

void writeFileBytes(const fs::path& file, std::string_view bytes) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        writeDirectly(file, bytes, file);
        return;
    }
    // A symbolic link stays one: what it points at is replaced.
    const fs::path target = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    fs::path partial = target;
    partial += ".part";
    writeDirectly(partial, bytes, file);
    fs::rename(partial, target, error);
    if (error) {
        const std::string reason = error.message();
        fs::remove(partial, error);
        throw InputError({file.string(), "", "cannot be written: " + reason,
                          "a file in a folder that exists and can be written"});
    }
}

} // namespace irsg
