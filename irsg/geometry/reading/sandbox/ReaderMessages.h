#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/sandbox/Bytes.h"
#include "irsg/geometry/reading/sandbox/ReadingLimits.h"

namespace irsg {

/// What ReaderProcess and ReaderService send each other.

/// What goes before the place and the name of a file that is asked for.
struct QuestionHead {
    std::uint8_t kind = 0; ///< a FileKind
    ReadingLimits limits;
    std::uint64_t placeSize = 0, nameSize = 0; ///< where the bytes are, and what they are called
};

/// What goes before the answer: remarks and a graph, a picture, or the diagnostics of a refusal.
struct AnswerHead {
    std::uint8_t refused = 0;
    std::uint64_t size = 0;
};

/// A refusal as an answer.
ByteSink refusalBytes(const std::vector<Diagnostic>& diagnostics);
/// Throws the InputError that the other process refused with.
[[noreturn]] void throwRefusal(std::string_view answer);

} // namespace irsg
