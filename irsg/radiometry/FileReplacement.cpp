#include "irsg/radiometry/FileReplacement.h"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "irsg/radiometry/Errors.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

constexpr auto patience = std::chrono::seconds(2);
constexpr auto pause = std::chrono::milliseconds(5);
constexpr mode_t ordinary = 0666;

[[noreturn]] void refuse(const fs::path& file, std::string value, std::string expected) {
    throw InputError({file.string(), "", std::move(value), std::move(expected)});
}

/// The same as a sentence of the system's error.
[[noreturn]] void refuse(const fs::path& file, int error) {
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        refuse(file, "a full disk", "room to write it; what was there is as it was");
    case EFBIG:
        refuse(file, "a file larger than is allowed here", "leave to write a larger file");
    case EACCES:
    case EPERM:
    case EROFS:
        refuse(file, "a place that cannot be written", "a file in a folder that may be written");
    case ENOENT:
    case ENOTDIR:
        refuse(file, "a folder that does not exist", "a file in a folder that exists");
    default:
        refuse(file, std::generic_category().message(error), "a file that may be written");
    }
}

/// True where the open file still has this name: its last owner may have moved it in the meantime.
bool isAt(int descriptor, const fs::path& path) {
    struct stat opened {};
    struct stat named {};
    return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/// Opens and locks the neighbour, empty; what a killed program left there is taken over.
int openAlone(const fs::path& part, const fs::path& target) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    for (;;) {
        const int descriptor = open(part.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, ordinary);
        if (descriptor < 0) {
            refuse(target, errno);
        }
        if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && isAt(descriptor, part)) {
            if (ftruncate(descriptor, 0) != 0) {
                const int error = errno;
                close(descriptor);
                refuse(target, error);
            }
            return descriptor;
        }
        close(descriptor);
        if (std::chrono::steady_clock::now() > deadline) {
            refuse(target, "a file that another program is writing", "one writer at a time");
        }
        std::this_thread::sleep_for(pause);
    }
}

void bringFolderToDisk(const fs::path& folder) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        // Some file systems cannot; the content of the file is on the disk already.
        static_cast<void>(fsync(descriptor));
        close(descriptor);
    }
}

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

} // namespace

FileReplacement::FileReplacement(const fs::path& target) : named_(target), target_(target) {
    std::error_code failure;
    if (fs::is_symlink(target, failure)) {
        target_ = fs::weakly_canonical(target, failure);
    }
    if (fs::is_directory(target_, failure)) {
        refuse(named_, "a folder", "the name of a file to write");
    }
    if (fs::exists(target_, failure) && !fs::is_regular_file(target_, failure)) {
        refuse(named_, "no regular file", "the name of a file to write");
    }
    if (!fs::is_directory(folderOf(target_), failure)) {
        refuse(named_, ENOENT);
    }
    part_ = folderOf(target_) / ("." + target_.filename().string() + ".part");
    descriptor_ = openAlone(part_, named_);
    // The new file may be read and written by whom the old one may.
    struct stat old {};
    if (stat(target_.c_str(), &old) == 0) {
        static_cast<void>(fchmod(descriptor_, old.st_mode & 07777));
    }
}

FileReplacement::~FileReplacement() {
    if (!done_) {
        std::error_code ignored;
        fs::remove(part_, ignored);
    }
    close(descriptor_);
}

void FileReplacement::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            refuse(named_, errno);
        }
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

void FileReplacement::commit(Existing existing) {
    if (fsync(descriptor_) != 0) {
        refuse(named_, errno);
    }
    if (existing == Existing::replace) {
        if (rename(part_.c_str(), target_.c_str()) != 0) {
            refuse(named_, errno);
        }
    } else if (renameat2(AT_FDCWD, part_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) !=
               0) {
        const int error = errno;
        if (error == EEXIST || fs::exists(target_)) {
            refuse(named_, "a file that exists already", "the name of a new file");
        }
        // Some file systems cannot tell in one step.
        if (error != EINVAL || rename(part_.c_str(), target_.c_str()) != 0) {
            refuse(named_, errno);
        }
    }
    done_ = true;
    bringFolderToDisk(folderOf(target_));
}

void writeFileDurably(const fs::path& file, std::string_view bytes) {
    FileReplacement replacement(file);
    replacement.write(bytes);
    replacement.commit();
}

} // namespace irsg
