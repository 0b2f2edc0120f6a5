#include "irsg/geometry/reading/sandbox/ReaderProcess.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <vector>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <osgDB/FileNameUtils>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/sandbox/ReaderMessages.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* programName = "irsg-reader";

/// Beside this library, in a build tree and where it is installed.
fs::path findProgram() {
    static const char here = 0;
    Dl_info info{};
    if (dladdr(&here, &info) == 0 || !info.dli_fname)
        throw LogicError("the place of irsg's library is not known");
    std::error_code failure;
    const fs::path folder = fs::canonical(info.dli_fname, failure).parent_path();
    for (const char* place : {".", "../bin", "../../bin", "../libexec", "../../libexec"})
        if (const fs::path program = folder / place / programName;
            access(program.c_str(), X_OK) == 0)
            return program;
    throw LogicError("the program " + std::string(programName) + " is not beside " +
                     folder.string());
}

/// Of our own surroundings what programs need to start. Numbers have points, messages are English.
std::vector<std::string> surroundings() {
    // Large pages: a process that lives for one model spends much of its time in asking for memory.
    std::vector<std::string> kept = {"LC_ALL=C", "GLIBC_TUNABLES=glibc.malloc.hugetlb=1"};
    for (const char* name : {"LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS", "LSAN_OPTIONS"})
        if (const char* value = std::getenv(name))
            kept.push_back(std::string(name) + "=" + value);
    return kept;
}

pid_t start(int socket) {
    const std::string program = findProgram().string();
    std::vector<std::string> kept = surroundings();
    std::vector<char*> environment;
    for (std::string& line : kept)
        environment.push_back(line.data());
    environment.push_back(nullptr);
    std::string name = programName;
    char* arguments[] = {name.data(), nullptr};

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    // The socket is what it is asked through; what plug-ins print goes nowhere.
    posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    // A group of its own: Ctrl-C is for the program that asks.
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF |
                                              POSIX_SPAWN_SETPGROUP);
    pid_t process = -1;
    const int error = posix_spawn(&process, program.c_str(), &actions, &attributes, arguments,
                                  environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        throw LogicError(program + " cannot be started: " + std::strerror(error));
    return process;
}

} // namespace

class ReaderProcess::Child {
  public:
    Child() {
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
            throw LogicError(std::string("no pair of sockets: ") + std::strerror(errno));
        socket_ = ends[0];
        try {
            process_ = start(ends[1]);
        } catch (...) {
            close(ends[0]);
            close(ends[1]);
            throw;
        }
        close(ends[1]);
    }
    ~Child() { end(); }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// False for a process that is gone, and for one that does not take the bytes in time.
    bool send(std::string_view bytes, Clock::time_point deadline) {
        while (!bytes.empty()) {
            const ssize_t count =
                ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
            if (count < 0 && (errno == EINTR || (errno == EAGAIN && await(POLLOUT, deadline))))
                continue;
            if (count <= 0)
                return false;
            bytes.remove_prefix(static_cast<std::size_t>(count));
        }
        return true;
    }

    enum class Received { all, nothingMore, tooLate };
    Received receive(char* into, std::size_t size, Clock::time_point deadline) {
        while (size > 0) {
            if (!await(POLLIN, deadline))
                return Received::tooLate;
            const ssize_t count = recv(socket_, into, size, 0);
            if (count < 0 && errno == EINTR)
                continue;
            if (count <= 0)
                return Received::nothingMore;
            into += count;
            size -= static_cast<std::size_t>(count);
        }
        return Received::all;
    }

    /// Ends the process without waiting for that.
    void stop() {
        if (process_ > 0)
            kill(process_, SIGKILL);
    }
    /// Ends the process, and tells how it had ended before that: the status of waitpid.
    int end() {
        if (process_ < 0)
            return status_;
        close(socket_);
        kill(process_, SIGKILL);
        while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
        return status_;
    }
    /// Waits for one that has closed its socket; its own end tells more than ours.
    int awaitEnd() {
        for (int i = 0; i < 200 && process_ >= 0; ++i) {
            const pid_t ended = waitpid(process_, &status_, WNOHANG);
            if (ended == process_) {
                process_ = -1;
                close(socket_);
                return status_;
            }
            usleep(5000);
        }
        return end();
    }

  private:
    /// Whether something can be read or written in time.
    bool await(short what, Clock::time_point deadline) const {
        int ready = 0;
        do {
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
            pollfd end{socket_, what, 0};
            ready = poll(&end, 1, static_cast<int>(std::max<long>(0, left.count())));
        } while (ready < 0 && errno == EINTR);
        return ready > 0;
    }

    int socket_ = -1, status_ = 0;
    pid_t process_ = -1;
};

namespace {

/// A model names no more; each wish for one takes our time.
constexpr std::size_t mostPictures = 65536;

Clock::duration patienceOf(const ReadingLimits& limits) {
    return std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(limits.wall_s()));
}

std::string readerTextOf(const fs::path& file) {
    return "the reader of " + readerNameOf(file.string());
}

std::string endText(int status, const ReadingLimits& limits, const fs::path& file) {
    const std::string reader = readerTextOf(file);
    if (WIFEXITED(status) && WEXITSTATUS(status) == otherVersion)
        return "a file for which there is a program irsg-reader of another build only";
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF)
        return "a file whose reading takes more than " + numberText(limits.processor_s) +
               " s of processor time";
    if (WIFSIGNALED(status))
        return "a file at which " + reader + " crashes (" +
               std::string(strsignal(WTERMSIG(status))) + ")";
    return "a file at which " + reader + " gives up (exit code " +
           std::to_string(WEXITSTATUS(status)) + ")";
}

/// Bytes of a file; of a text of glTF with the numbers that may belong to it and lie beside it.
std::uint64_t sizeOf(const fs::path& place, const fs::path& file) {
    std::error_code failure;
    const std::uintmax_t own = fs::file_size(place, failure);
    std::uint64_t size = failure ? 0 : own;
    if (osgDB::getLowerCaseFileExtension(file.string()) != "gltf")
        return size;
    for (fs::directory_iterator entry(file.parent_path().empty() ? "." : file.parent_path(),
                                      failure);
         !failure && entry != fs::directory_iterator(); entry.increment(failure))
        if (std::error_code unknown; entry->is_regular_file(unknown) &&
                                     !refusalOf(entry->path().string(), FileKind::buffers))
            if (const std::uintmax_t beside = entry->file_size(unknown); !unknown)
                size += std::min<std::uint64_t>(beside, largestModel_B);
    return size;
}

[[noreturn]] void refuseReading(const fs::path& file, FileKind kind, std::string value) {
    throw InputError({file.string(), "", std::move(value),
                      kind == FileKind::model ? "a whole model" : "a whole picture"});
}

} // namespace

ReaderProcess::ReaderProcess() = default;
ReaderProcess::~ReaderProcess() = default;

void ReaderProcess::dismiss() {
    if (child_)
        child_->stop();
}

ReaderAnswer ReaderProcess::read(FileKind kind, const fs::path& place, const fs::path& name,
                                 const OwnFiles* own) {
    const fs::path& file = name.empty() ? place : name;
    // Each opens the files of its first question alone.
    if (child_ && (kind == FileKind::model || file.parent_path() != folder_))
        child_.reset();
    if (!child_)
        child_ = std::make_unique<Child>();
    folder_ = own ? std::nullopt : std::optional(file.parent_path());
    if (place == file)
        noteInput(file);
    const std::size_t contents = own ? own->contents.size() : 0;
    const ReadingLimits limits = ReadingLimits::of(contents > 0              ? contents
                                                   : kind == FileKind::model ? sizeOf(place, file)
                                                                             : sizeOf(place, {}));
    ByteSink ownFiles;
    if (own)
        putOwnFiles(ownFiles, *own);
    ByteSink question;
    question.put(QuestionHead{messagesVersion, static_cast<std::uint8_t>(kind), limits,
                              place.native().size(), file.native().size(), ownFiles.size(),
                              contents});
    question.putBytes(place.native().data(), place.native().size());
    question.putBytes(file.native().data(), file.native().size());
    question.append(std::move(ownFiles));
    // One that is gone has its end to tell.
    const auto deadline = Clock::now() + patienceOf(limits);
    bool isThere = child_->send(question.take(), deadline);
    for (std::size_t i = 0; isThere && own && i < own->contents.pieces().size(); ++i)
        isThere = child_->send(own->contents.pieces()[i], deadline);
    return receive(file, kind, limits, own);
}

ReaderAnswer ReaderProcess::receive(const fs::path& file, FileKind kind,
                                    const ReadingLimits& limits, const OwnFiles* own) {
    auto deadline = Clock::now() + patienceOf(limits);
    std::uint64_t most_B = limits.memory_B;
    for (std::size_t wishes = 0;;) {
        AnswerHead head;
        ReaderAnswer answer(0);
        auto received = child_->receive(reinterpret_cast<char*>(&head), sizeof head, deadline);
        if (received == Child::Received::all) {
            if (head.size > most_B || wishes > mostPictures)
                received = Child::Received::nothingMore;
            else {
                answer = ReaderAnswer(head.size);
                received = child_->receive(answer.data(), head.size, deadline);
            }
        }
        if (received != Child::Received::all) {
            const std::unique_ptr<Child> child = std::move(child_);
            if (received == Child::Received::tooLate)
                refuseReading(file, kind,
                              "a file whose reading takes more than " +
                                  numberText(limits.wall_s()) + " s");
            refuseReading(file, kind, endText(child->awaitEnd(), limits, file));
        }
        if (head.kind == AnswerKind::refusal)
            throwRefusal(answer.bytes());
        if (head.kind != AnswerKind::picture)
            return answer;
        ++wishes;
        const auto begin = Clock::now();
        most_B += handOver(answer, file, limits, own);
        deadline += Clock::now() - begin;
    }
}

std::uint64_t ReaderProcess::handOver(const ReaderAnswer& wish, const fs::path& model,
                                      const ReadingLimits& limits, const OwnFiles* own) {
    ByteSource source(wish.bytes());
    const fs::path picture = source.getText();
    if (!own || std::ranges::find(own->pictures, picture) == own->pictures.end())
        throw InputError({model.string(), "",
                          "a file at which " + readerTextOf(model) + " asks for " +
                              picture.string() + ", which the model does not name",
                          "a whole model"});
    if (!pictures_)
        pictures_ = std::make_unique<ReaderProcess>();
    const auto give = [&](AnswerKind kind, std::string_view bytes) {
        const AnswerHead head{kind, bytes.size()};
        // One that is gone has its end to tell, and one that takes nothing is too late.
        const auto deadline = Clock::now() + patienceOf(limits);
        if (child_->send({reinterpret_cast<const char*>(&head), sizeof head}, deadline))
            child_->send(bytes, deadline);
        return std::uint64_t{bytes.size()};
    };
    try {
        return give(AnswerKind::result, pictures_->read(FileKind::picture, picture).bytes());
    } catch (const InputError& error) {
        return give(AnswerKind::refusal, refusalBytes(error.diagnostics()).take());
    }
}

} // namespace irsg
