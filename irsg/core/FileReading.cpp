#include "irsg/core/FileReading.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <map>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, std::string value, std::string expected) {
    throw InputError({file.string(), "", std::move(value), std::move(expected)});
}

[[noreturn]] void refuse(const fs::path& file, int error) {
    if (error == ENOENT)
        refuse(file, "no such file", "a file that exists");
    refuse(file, "a file that cannot be read: " + std::generic_category().message(error),
           "a file that may be read");
}

[[noreturn]] void refuseTooLarge(const fs::path& file, const std::string& size_B,
                                 std::uint64_t most_B) {
    refuse(file, size_B + " bytes", "at most " + std::to_string(most_B >> 20) + " MiB");
}

using Identity = std::pair<dev_t, ino_t>;

struct Inputs {
    std::atomic<bool> wanted = false;
    std::mutex mutex;
    std::map<Identity, fs::path> read;
    std::set<Identity> changed;
};

Inputs& inputs() {
    static Inputs inputs;
    return inputs;
}

void note(const struct stat& status, const fs::path& file) {
    Inputs& all = inputs();
    if (!all.wanted)
        return;
    const std::scoped_lock lock(all.mutex);
    all.read.try_emplace({status.st_dev, status.st_ino}, file);
}

class OpenFile {
  public:
    explicit OpenFile(const fs::path& file) : file_(file) {
        // A pipe that nobody writes to would wait for ever at this line.
        descriptor_ = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        if (descriptor_ < 0)
            refuse(file, errno);
        if (fstat(descriptor_, &status_) != 0) {
            const int error = errno;
            close(descriptor_);
            refuse(file, error);
        }
        if (!S_ISREG(status_.st_mode)) {
            close(descriptor_);
            refuse(file, S_ISDIR(status_.st_mode) ? "a folder" : "something that is no file",
                   "a file");
        }
        note(status_, file);
    }
    ~OpenFile() { close(descriptor_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    std::uint64_t size() const { return static_cast<std::uint64_t>(status_.st_size); }

    /// What follows, in the room of `piece`; empty at the end of the file.
    std::string_view next(std::string& piece) const {
        for (;;) {
            const ssize_t count = ::read(descriptor_, piece.data(), piece.size());
            if (count >= 0)
                return std::string_view(piece).substr(0, static_cast<std::size_t>(count));
            if (errno != EINTR)
                refuse(file_, errno);
        }
    }
    /// At most `most` bytes, fewer at the end of the file.
    std::string read(std::size_t most) const {
        constexpr std::size_t piece = 4096;
        const std::size_t wanted = std::min<std::size_t>(most, size());
        std::string bytes;
        bytes.reserve(wanted + piece); // so that looking for the end does not double it
        while (bytes.size() < most) {
            const std::size_t before = bytes.size();
            // A file that grows while it is read, or lies about its size, is read in pieces.
            bytes.resize(before + std::max(wanted - std::min(wanted, before), piece));
            const ssize_t count =
                ::read(descriptor_, bytes.data() + before, std::min(bytes.size(), most) - before);
            if (count < 0 && errno != EINTR)
                refuse(file_, errno);
            bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
            if (count == 0)
                break;
        }
        return bytes;
    }

  private:
    const fs::path& file_;
    int descriptor_ = -1;
    struct stat status_ {};
};

} // namespace

std::string readFile(const fs::path& file, std::uint64_t most_B) {
    const OpenFile open(file);
    if (open.size() > most_B)
        refuseTooLarge(file, std::to_string(open.size()), most_B);
    std::string bytes = open.read(static_cast<std::size_t>(most_B) + 1);
    if (bytes.size() > most_B)
        refuseTooLarge(file, "more than " + std::to_string(most_B), most_B);
    return bytes;
}

void readFileInPieces(const fs::path& file, const std::function<void(std::string_view)>& take,
                      std::uint64_t most_B) {
    const OpenFile open(file);
    if (open.size() > most_B)
        refuseTooLarge(file, std::to_string(open.size()), most_B);
    std::string piece(std::size_t{1} << 20, '\0');
    std::uint64_t read_B = 0;
    for (std::string_view next = open.next(piece); !next.empty(); next = open.next(piece)) {
        read_B += next.size();
        if (read_B > most_B)
            refuseTooLarge(file, "more than " + std::to_string(most_B), most_B);
        take(next);
    }
}

std::string readFileBeginning(const fs::path& file, std::size_t size) {
    return OpenFile(file).read(size);
}

void protectInputs() {
    inputs().wanted = true;
}

void noteInput(const fs::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) == 0)
        note(status, file);
}

std::vector<fs::path> inputsRead() {
    Inputs& all = inputs();
    const std::scoped_lock lock(all.mutex);
    std::vector<fs::path> files;
    for (const auto& [identity, file] : all.read)
        files.push_back(file);
    return files;
}

void refuseInputAsOutput(const fs::path& output) {
    Inputs& all = inputs();
    struct stat status {};
    if (!all.wanted || stat(output.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
        return;
    const std::scoped_lock lock(all.mutex);
    const Identity identity{status.st_dev, status.st_ino};
    if (all.read.contains(identity) && !all.changed.contains(identity))
        refuse(output, "an input as output", "another file");
}

void allowChange(const fs::path& file) {
    Inputs& all = inputs();
    struct stat status {};
    if (!all.wanted || stat(file.c_str(), &status) != 0)
        return;
    const std::scoped_lock lock(all.mutex);
    all.changed.emplace(status.st_dev, status.st_ino);
}

} // namespace irsg
