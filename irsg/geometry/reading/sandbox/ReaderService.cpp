#include "irsg/geometry/reading/sandbox/ReaderService.h"

#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <csignal>
#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/sandbox/AskingProgram.h"
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
void shutInWith(FileKind kind, const std::string& place, const std::string& name,
                const std::optional<OwnFiles>& own) {
    const std::filesystem::path file(name);
    ReadablePlaces places;
    if (own) {
        places.read = own->opened;
    } else {
        places.read = {file.parent_path(), place};
        if (kind == FileKind::model)
            for (const std::filesystem::path& named : filesNamedOutside(place, file)) {
                places.read.push_back(named);
                // Its name may be written in other upper and lower case.
                places.listed.push_back(named.parent_path());
            }
    }
    confineFiles(places);
    shutIn();
}

} // namespace

void serveReadings(int socket) {
    beginToServe();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    preparePlugins();
    bool isShutIn = false;
    for (QuestionHead question; readFrom(socket, &question, sizeof question);) {
        if (question.version != messagesVersion)
            _exit(otherVersion);
        std::string place(question.placeSize, '\0'), name(question.nameSize, '\0'),
            own(question.ownSize, '\0');
        std::string contents(question.contentsSize, '\0');
        if (!readFrom(socket, place.data(), place.size()) ||
            !readFrom(socket, name.data(), name.size()) ||
            !readFrom(socket, own.data(), own.size()) ||
            !readFrom(socket, contents.data(), contents.size()))
            return;
        const auto kind = static_cast<FileKind>(question.kind);
        std::optional<OwnFiles> files;
        if (!own.empty()) {
            ByteSource source(own);
            files = getOwnFiles(source);
            useFoundNames(files->names);
            setAsked(socket, files->wantsPictures, std::move(contents));
        }
        if (!std::exchange(isShutIn, true)) {
            place = ownPlace(place, name);
            shutInWith(kind, place, name, files);
        }
        allow(question.limits);
        bool refused = false;
        const ByteSink bytes = answer(kind, place, name, refused);
        stopClock();
        if (!writeAnswerTo(socket, refused ? AnswerKind::refusal : AnswerKind::result, bytes))
            return;
    }
}

} // namespace irsg
