#pragma once

#include <cstdint>

namespace irsg {

/// What the reading of one file may take. A file tells by its size how much it can become.
struct ReadingLimits {
    std::uint64_t memory_B = 0;
    double processor_s = 0.0;

    static ReadingLimits of(std::uint64_t file_B);
    /// Of the clock on the wall, on a machine that has other things to do, too.
    double wall_s() const { return 5.0 + 8.0 * processor_s; }
};

/// Takes from this process for good what reading a file does not need: writing files, the network,
/// other programs, other processes (their signals and limits, too), threads. Whoever takes it over
/// through a damaged file finds itself with nothing to do. Throws LogicError where the system does
/// not allow that.
void shutIn();

/// From now on: so much memory and so much processor time until the end of this process.
void allow(const ReadingLimits& limits);
/// Memory for a file that belongs to the one that is read, a texture say.
void allowMore(std::uint64_t file_B);
/// So much more memory.
void allowBytes(std::uint64_t memory_B);
/// No clock runs until the next question.
void stopClock();

} // namespace irsg
