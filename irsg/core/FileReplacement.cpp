#include "irsg/core/FileReplacement.h"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <map>
#include <mutex>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include "irsg/core/AtomicRename.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

constexpr mode_t ordinary = 0666;
constexpr std::string_view partEnding = ".part";

[[noreturn]] void refuseToWrite(const fs::path& file, std::string value, std::string expected) {
    throw InputError({file.string(), "", std::move(value), std::move(expected)});
}

/// The same as a sentence of the system's error.
[[noreturn]] void refuseToWrite(const fs::path& file, int error) {
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        refuseToWrite(file, "a full disk", "room to write it; what was there is as it was");
    case EFBIG:
        refuseToWrite(file, "a file larger than is allowed here",
                      "leave to write a larger file; what was there is as it was");
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

/// Twelve letters that nobody foresees.
std::string randomName() {
    unsigned char bytes[12] = {};
    static_cast<void>(getrandom(bytes, sizeof bytes, 0));
    std::string name;
    for (const unsigned char byte : bytes)
        name += static_cast<char>('a' + byte % 26);
    return name;
}

fs::path neighbourOf(const fs::path& target) {
    constexpr std::size_t longest = 200; // of the 255 bytes that names have
    return folderOf(target) / ("." + target.filename().string().substr(0, longest) + "." +
                               randomName() + std::string(partEnding));
}

bool isLeftOver(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.size() > 19 && name[0] == '.' && name.ends_with(partEnding) &&
           name[name.size() - 18] == '.';
}

/// Removes what killed programs left: neighbours that nobody holds a lock on. Looks into a folder
/// once a second at most: one of ten thousand frames is not looked through for each of them.
void sweep(const fs::path& folder) {
    using Clock = std::chrono::steady_clock;
    static std::mutex mutex;
    static std::map<fs::path, Clock::time_point> swept;
    std::error_code failure;
    const std::scoped_lock lock(mutex);
    const auto now = Clock::now();
    const auto [known, added] = swept.try_emplace(fs::weakly_canonical(folder, failure), now);
    if (!added && now - known->second < std::chrono::seconds(1))
        return;
    known->second = now;
    for (const auto& entry : fs::directory_iterator(folder, failure)) {
        if (!isLeftOver(entry.path()) || !entry.is_regular_file(failure))
            continue;
        const int descriptor = open(entry.path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
        if (descriptor < 0)
            continue;
        if (flock(descriptor, LOCK_EX | LOCK_NB) == 0)
            fs::remove(entry.path(), failure);
        close(descriptor);
    }
}

bool meansNoFilesWithoutNames(int error) {
    return error == EOPNOTSUPP || error == EISDIR || error == EINVAL;
}

/// How a file without a name is called.
std::string callingOf(int descriptor) {
    return "/proc/self/fd/" + std::to_string(descriptor);
}

} // namespace

FileReplacement::FileReplacement(const fs::path& target, Input input)
    : named_(target), target_(target) {
    std::error_code failure;
    if (fs::is_symlink(target, failure))
        target_ = fs::weakly_canonical(target, failure);
    if (fs::is_directory(target_, failure))
        refuseToWrite(named_, "a folder", "the name of a file to write");
    if (fs::exists(target_, failure) && !fs::is_regular_file(target_, failure))
        refuseToWrite(named_, "no regular file", "the name of a file to write");
    const fs::path folder = folderOf(target_);
    if (!fs::is_directory(folder, failure))
        refuseToWrite(named_, ENOENT);
    if (input == Input::refuse)
        refuseInputAsOutput(named_);
    sweep(folder);

    descriptor_ = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, ordinary);
    if (descriptor_ >= 0 && access(callingOf(descriptor_).c_str(), F_OK) != 0) {
        close(descriptor_); // without /proc it would never get a name
        descriptor_ = -1;
    } else if (descriptor_ < 0 && !meansNoFilesWithoutNames(errno)) {
        refuseToWrite(named_, errno);
    }
    isOnDiskOfTarget_ = descriptor_ >= 0;
    if (!isOnDiskOfTarget_)
        descriptor_ = memfd_create("smat", MFD_CLOEXEC);
    if (descriptor_ < 0)
        refuseToWrite(named_, errno);
    // Whoever sweeps leaves alone what is locked.
    static_cast<void>(flock(descriptor_, LOCK_EX | LOCK_NB));
    try {
        takePermissions();
    } catch (...) {
        close(descriptor_);
        throw;
    }
}

FileReplacement::~FileReplacement() {
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

/// Its only name at once, where nothing has it; 0 or the system's error.
int FileReplacement::linkToTarget() const {
    return linkat(AT_FDCWD, callingOf(descriptor_).c_str(), AT_FDCWD, target_.c_str(),
                  AT_SYMLINK_FOLLOW) == 0
               ? 0
               : errno;
}

/// 0 or the system's error.
int FileReplacement::atomicRenameToTarget(Existing existing) const {
    struct stat old {};
    const bool stands = stat(target_.c_str(), &old) == 0;
    const std::string calling = callingOf(descriptor_), part = neighbourOf(target_).string();
    return atomicRename({descriptor_, isOnDiskOfTarget_, calling.c_str(), part.c_str(),
                         target_.c_str(), stands ? &old : nullptr, existing == Existing::replace});
}

void FileReplacement::commit(Existing existing) {
    if (fsync(descriptor_) != 0)
        refuseToWrite(named_, errno);
    std::error_code failure;
    const bool stands = fs::exists(fs::symlink_status(target_, failure));
    int error = EEXIST;
    if (isOnDiskOfTarget_ && (existing == Existing::refuse || !stands))
        error = linkToTarget();
    if (error == EEXIST && (existing == Existing::replace || !isOnDiskOfTarget_))
        error = atomicRenameToTarget(existing);
    if (error == EEXIST)
        refuseToWrite(named_, "a file that exists already", "the name of a new file");
    if (error != 0)
        refuseToWrite(named_, error);
    bringFolderToDisk(folderOf(target_));
}

void writeFileDurably(const fs::path& file, std::string_view bytes) {
    std::error_code failure;
    const fs::file_status status = fs::status(file, failure);
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) {
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

} // namespace irsg
