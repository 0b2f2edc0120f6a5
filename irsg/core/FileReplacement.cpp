#include "irsg/core/FileReplacement.h"

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/WriteGuard.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

constexpr mode_t ordinary = 0666;

[[noreturn]] void refuseToWrite(const fs::path& file, std::string value, std::string expected) {
    throw InputError({file.string(), "", std::move(value), std::move(expected)});
}

/// The same as a sentence of the system's error.
[[noreturn]] void refuseToWrite(const fs::path& file, int error) {
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        refuseToWrite(file, "a full disk", "room to write it; the old file is unchanged");
    case EFBIG:
        refuseToWrite(file, "a file larger than is allowed here",
                      "permission to write a larger file; the old file is unchanged");
    case EACCES:
    case EPERM:
    case EROFS:
        refuseToWrite(file, "a place that cannot be written",
                      "a file in a folder that may be written");
    case ENOENT:
    case ENOTDIR:
        refuseToWrite(file, "a folder that does not exist", "a file in a folder that exists");
    default:
        refuseToWrite(file, std::generic_category().message(error), "a file that may be written");
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

/// Whether the name is that of the open file.
bool isNameOf(const fs::path& name, int descriptor) {
    struct stat named {
    }, opened{};
    return lstat(name.c_str(), &named) == 0 && fstat(descriptor, &opened) == 0 &&
           named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

/// Removes a hidden neighbour that nobody holds a lock on: who wrote it was killed. False where
/// somebody writes it now, or it cannot be removed.
bool removeLeftOver(const fs::path& part) {
    const int descriptor = open(part.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0)
        return errno == ENOENT;
    const bool isGone = flock(descriptor, LOCK_EX | LOCK_NB) == 0 &&
                        (!isNameOf(part, descriptor) || unlink(part.c_str()) == 0);
    close(descriptor);
    return isGone;
}

/// A new file beside the target, and its lock. The name is the first that no other writer of the
/// target has; the left-over of one that was killed makes room. -1: see errno.
int openPart(const fs::path& target, fs::path& part) {
    constexpr std::size_t longest = 200; // of the 255 bytes that names have
    const std::string stem = "." + target.filename().string().substr(0, longest) + ".smat-";
    for (int writer = 0;;) {
        part = folderOf(target) / (stem + std::to_string(writer) + ".part");
        const int descriptor =
            open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, ordinary);
        if (descriptor < 0) {
            if (errno != EEXIST)
                return -1;
            if (!removeLeftOver(part))
                ++writer;
            continue;
        }
        // Some file systems know no locks; where they do, another writer may have taken it for a
        // left-over meanwhile.
        const bool isTaken = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        if (!isTaken && isNameOf(part, descriptor))
            return descriptor;
        close(descriptor);
    }
}

/// Gives the file its name where nothing has it; 0 or the system's error.
int renameToNew(const fs::path& part, const fs::path& target) {
    if (renameat2(AT_FDCWD, part.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0)
        return 0;
    // Some file systems cannot tell in one step.
    if (errno != EINVAL)
        return errno;
    if (link(part.c_str(), target.c_str()) != 0)
        return errno;
    unlink(part.c_str());
    return 0;
}

/// The file that a name leads to.
fs::path behindLink(const fs::path& named) {
    std::error_code failure;
    return fs::is_symlink(named, failure) ? fs::weakly_canonical(named, failure) : named;
}

WriteGuard& writeGuard() {
    static WriteGuard guard;
    return guard;
}

/// Throws InputError where no regular file can stand, or none is to be written.
void checkPlace(const fs::path& named, const fs::path& target) {
    std::error_code failure;
    if (fs::is_directory(target, failure))
        refuseToWrite(named, "a folder", "the name of a file to write");
    if (fs::exists(target, failure) && !fs::is_regular_file(target, failure))
        refuseToWrite(named, "no regular file", "the name of a file to write");
    if (!fs::is_directory(folderOf(target), failure))
        refuseToWrite(named, ENOENT);
    if (writeGuard())
        writeGuard()(target);
}

/// True for a device or a pipe, which is written as it stands.
bool isWrittenInPlace(const fs::path& file) {
    std::error_code failure;
    const fs::file_status status = fs::status(file, failure);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

} // namespace

void writeAll(int descriptor, std::string_view bytes, const fs::path& named) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            refuseToWrite(named, errno);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

void setWriteGuard(WriteGuard guard) {
    writeGuard() = std::move(guard);
}

FileReplacement::FileReplacement(const fs::path& target, Input input)
    : named_(target), target_(behindLink(target)) {
    checkPlace(named_, target_);
    if (input == Input::refuse)
        refuseInputAsOutput(named_);
    descriptor_ = openPart(target_, part_);
    if (descriptor_ < 0)
        refuseToWrite(named_, errno);
    try {
        takePermissions();
    } catch (...) {
        removePart();
        throw;
    }
}

FileReplacement::~FileReplacement() {
    removePart();
}

void FileReplacement::removePart() {
    if (!isCommitted_)
        unlink(part_.c_str());
    close(descriptor_);
}

void FileReplacement::takePermissions() {
    struct stat old {};
    if (stat(target_.c_str(), &old) != 0)
        return;
    if ((old.st_mode & 0222) == 0)
        refuseToWrite(named_, "a write-protected file", "a file that can be written");
    // Who may not give files away keeps his own.
    static_cast<void>(!fchown(descriptor_, old.st_uid, old.st_gid));
    static_cast<void>(fchmod(descriptor_, old.st_mode & 07777));
}

void FileReplacement::write(std::string_view bytes) {
    writeAll(descriptor_, bytes, named_);
}

void FileReplacement::commit(Existing existing) {
    if (fsync(descriptor_) != 0)
        refuseToWrite(named_, errno);
    int error = 0;
    if (existing == Existing::refuse)
        error = renameToNew(part_, target_);
    else if (rename(part_.c_str(), target_.c_str()) != 0)
        error = errno;
    if (error == EEXIST)
        refuseToWrite(named_, "a file that exists already", "the name of a new file");
    if (error != 0)
        refuseToWrite(named_, error);
    isCommitted_ = true;
    bringFolderToDisk(folderOf(target_));
}

void writeFileDurably(const fs::path& file, std::string_view bytes) {
    if (isWrittenInPlace(file)) {
        const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor < 0)
            refuseToWrite(file, errno);
        try {
            writeAll(descriptor, bytes, file);
        } catch (...) {
            close(descriptor);
            throw;
        }
        close(descriptor);
        return;
    }
    FileReplacement replacement(file);
    replacement.write(bytes);
    replacement.commit();
}

void checkWritable(const fs::path& file) {
    if (isWrittenInPlace(file)) {
        if (access(file.c_str(), W_OK) != 0)
            refuseToWrite(file, errno);
        return;
    }
    const FileReplacement begun(file); // and given up
}

void checkFolderWritable(const fs::path& folder, const fs::path& named) {
    if (writeGuard())
        writeGuard()(folder / "file");
    fs::path part;
    const int descriptor = openPart(folder / "folder", part);
    if (descriptor < 0)
        refuseToWrite(named, errno);
    unlink(part.c_str());
    close(descriptor);
}

} // namespace irsg
