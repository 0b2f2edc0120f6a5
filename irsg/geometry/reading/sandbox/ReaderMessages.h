#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "irsg/core/Bytes.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/sandbox/OwnFiles.h"
#include "irsg/geometry/reading/sandbox/ReadingLimits.h"

namespace irsg {

/// What ReaderProcess and ReaderService send each other. Both are built together; what another
/// build asks for is not answered.
constexpr std::uint32_t messagesVersion = 2;
/// The exit code of a process that is asked in another version.
constexpr int otherVersion = 4;

/// What goes before the place and the name of a file that is asked for, its OwnFiles and their
/// contents.
struct QuestionHead {
    std::uint32_t version = messagesVersion;
    std::uint8_t kind = 0; ///< a FileKind
    ReadingLimits limits;
    std::uint64_t placeSize = 0, nameSize = 0; ///< where the bytes are, and what they are called
    std::uint64_t ownSize = 0;                 ///< 0 where OwnFiles are not known
    std::uint64_t contentsSize = 0;
};

enum class AnswerKind : std::uint8_t {
    result,  ///< remarks and a graph, or a picture
    refusal, ///< its diagnostics
    picture  ///< of the process alone: a picture is wanted, by this name; an answer goes back
};

/// What goes before the answer.
struct AnswerHead {
    AnswerKind kind = AnswerKind::result;
    std::uint64_t size = 0;
};

/// A refusal as an answer.
ByteSink refusalBytes(const std::vector<Diagnostic>& diagnostics);
/// Throws the InputError that the other process refused with.
[[noreturn]] void throwRefusal(std::string_view answer);

} // namespace irsg
