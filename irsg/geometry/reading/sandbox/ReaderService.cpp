#include "irsg/geometry/reading/sandbox/ReaderService.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <csignal>
#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/sandbox/AxesCoding.h"
#include "irsg/geometry/reading/sandbox/FileConfinement.h"
#include "irsg/geometry/reading/sandbox/GraphCoding.h"
#include "irsg/geometry/reading/sandbox/NamedFiles.h"
#include "irsg/geometry/reading/sandbox/PluginReading.h"
#include "irsg/geometry/reading/sandbox/ReaderMessages.h"
#include "irsg/geometry/reading/sandbox/ReadingLimits.h"
#include "irsg/geometry/reading/sandbox/StateCoding.h"

namespace irsg {

namespace {

bool serving = false;

/// Calls transfer(done, left), which reads or writes some of what is left, until nothing is; false
/// where the other side is gone.
template <typename Transfer>
bool transferAll(std::size_t size, Transfer transfer) {
    for (std::size_t done = 0; done < size;) {
        const ssize_t count = transfer(done, size - done);
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return false;
        done += static_cast<std::size_t>(count);
    }
    return true;
}

bool readAll(int socket, void* into, std::size_t size) {
    return transferAll(size, [&](std::size_t done, std::size_t left) {
        return ::read(socket, static_cast<char*>(into) + done, left);
    });
}

bool writeAll(int socket, const void* from, std::size_t size) {
    return transferAll(size, [&](std::size_t done, std::size_t left) {
        return ::write(socket, static_cast<const char*>(from) + done, left);
    });
}

ByteSink answerTo(FileKind kind, const std::filesystem::path& place,
                  const std::filesystem::path& file) {
    ByteSink sink;
    if (kind == FileKind::picture) {
        putImage(sink, *readPictureHere(file));
        return sink;
    }
    LoadedGraph loaded = readModelHere(place, file);
    ByteSink graph;
    putGraph(graph, *loaded.node, file.string(), loaded.remarks);
    sink.putCount(loaded.remarks.size());
    for (const std::string& remark : loaded.remarks)
        sink.putText(remark);
    putAxes(sink, loaded.axes);
    sink.append(std::move(graph));
    return sink;
}

/// The answer to one question; what is wrong with a file is an answer, too.
ByteSink answer(FileKind kind, const std::string& place, const std::string& name, bool& refused) {
    const auto refuse = [&](const std::string& value) {
        refused = true;
        return refusalBytes(
            {{name, "", value, kind == FileKind::model ? "a whole model" : "a whole picture"}});
    };
    try {
        return answerTo(kind, place, name);
    } catch (const InputError& error) {
        refused = true;
        return refusalBytes(error.diagnostics());
    } catch (const std::bad_alloc&) {
        return refuse("a file whose reading takes more memory than a file of its size may");
    } catch (const std::exception& error) {
        return refuse("a file that " + readerNameOf(name) + " cannot read (" + error.what() + ")");
    }
}

/// The name by which this process finds the bytes of a model when it is shut in: those of another
/// process's file are opened before.
std::string ownPlace(const std::string& place, const std::string& name) {
    if (place == name)
        return place;
    const int descriptor = open(place.c_str(), O_RDONLY | O_CLOEXEC);
    return descriptor < 0 ? place : "/proc/self/fd/" + std::to_string(descriptor);
}

/// Gives up all files but those that belong to the first question, and all else (shutIn).
void shutInWith(FileKind kind, const std::string& place, const std::string& name) {
    const std::filesystem::path file(name);
    std::vector<std::filesystem::path> files = {place};
    if (kind == FileKind::model)
        for (std::filesystem::path& named : filesNamedOutside(place, file))
            files.push_back(std::move(named));
    confineFiles(file.parent_path(), files);
    shutIn();
}

} // namespace

bool isReader() {
    return serving;
}

void serveReadings(int socket) {
    serving = true;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    preparePlugins();
    bool isShutIn = false;
    for (QuestionHead question; readAll(socket, &question, sizeof question);) {
        std::string place(question.placeSize, '\0'), name(question.nameSize, '\0');
        if (!readAll(socket, place.data(), place.size()) ||
            !readAll(socket, name.data(), name.size()))
            return;
        if (!std::exchange(isShutIn, true)) {
            place = ownPlace(place, name);
            shutInWith(static_cast<FileKind>(question.kind), place, name);
        }
        allow(question.limits);
        AnswerHead head;
        bool refused = false;
        const ByteSink bytes = answer(static_cast<FileKind>(question.kind), place, name, refused);
        head.refused = refused;
        head.size = bytes.size();
        stopClock();
        if (!writeAll(socket, &head, sizeof head) ||
            !std::ranges::all_of(bytes.pieces(), [&](const std::string& piece) {
                return writeAll(socket, piece.data(), piece.size());
            }))
            return;
    }
}

} // namespace irsg
