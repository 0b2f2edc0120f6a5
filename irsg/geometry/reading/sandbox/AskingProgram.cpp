#include "irsg/geometry/reading/sandbox/AskingProgram.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <unistd.h>

#include "irsg/geometry/reading/sandbox/ReadingLimits.h"
#include "irsg/geometry/reading/sandbox/StateCoding.h"

namespace irsg {

namespace {

bool serving = false;

/// Who asks for a model with OwnFiles, -1 for another question.
int apart = -1;
bool wantsPictures = true;
/// Of the model, where they came with the question.
std::string contents;

/// Of a picture as bytes: as it comes, as a picture, and on its way back.
constexpr std::uint64_t mostCopiesOfPicture = 4;

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

bool writeAll(int socket, const void* from, std::size_t size) {
    return transferAll(size, [&](std::size_t done, std::size_t left) {
        return ::write(socket, static_cast<const char*>(from) + done, left);
    });
}

} // namespace

bool isReader() {
    return serving;
}

void beginToServe() {
    serving = true;
}

void setAsked(int socket, bool pictures, std::string bytes) {
    apart = socket;
    wantsPictures = pictures;
    contents = std::move(bytes);
}

bool arePicturesApart() {
    return apart >= 0;
}

bool arePicturesWanted() {
    return wantsPictures;
}

std::string takeContents() {
    return std::exchange(contents, {});
}

bool readFrom(int socket, void* into, std::size_t size) {
    return transferAll(size, [&](std::size_t done, std::size_t left) {
        return ::read(socket, static_cast<char*>(into) + done, left);
    });
}

bool writeAnswerTo(int socket, AnswerKind kind, const ByteSink& bytes) {
    const AnswerHead head{kind, bytes.size()};
    return writeAll(socket, &head, sizeof head) &&
           std::ranges::all_of(bytes.pieces(), [&](const std::string& piece) {
               return writeAll(socket, piece.data(), piece.size());
           });
}

osg::ref_ptr<osg::Image> pictureFromApart(const std::filesystem::path& file) {
    ByteSink name;
    name.putText(file.native());
    AnswerHead head;
    if (!writeAnswerTo(apart, AnswerKind::picture, name) || !readFrom(apart, &head, sizeof head))
        throw DamagedBytes("nobody who hands over pictures");
    allowBytes(mostCopiesOfPicture * head.size);
    std::string bytes(head.size, '\0');
    if (!readFrom(apart, bytes.data(), bytes.size()))
        throw DamagedBytes("nobody who hands over pictures");
    if (head.kind == AnswerKind::refusal)
        throwRefusal(bytes);
    ByteSource source(bytes);
    return getImage(source);
}

} // namespace irsg
