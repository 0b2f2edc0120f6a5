#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace irsg {

/// Calls work(0) to work(count - 1), each once, in any order and on all cores; returns when all are
/// done. Results do not depend on the number of cores where every call writes to a place of its own
/// that follows from its number. Where another call of this function is under way, this one works
/// on the calling thread alone. Throws what the call of the lowest number threw.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work);

/// parallelFor of work so small that handing out its numbers would take a part of the time: sixteen
/// at once. Numbers have 32 bits, as indices into meshes have.
void parallelForSmall(std::size_t count, const std::function<void(std::uint32_t)>& work);

/// While it lives parallelFor works on the calling thread alone where it is called from that
/// thread: for what goes on beside other work, which would otherwise get in each other's way.
class OnThisThread {
  public:
    OnThisThread();
    ~OnThisThread();
    OnThisThread(const OnThisThread&) = delete;
    OnThisThread& operator=(const OnThisThread&) = delete;
};

/// Splits 0 to before size into `parts` nearly equal pieces: piece `part` begins here and ends
/// where the next begins.
constexpr std::size_t beginOfPart(std::size_t part, std::size_t parts, std::size_t size) {
    return size * part / parts;
}

/// Limits the threads that parallelFor uses; 0: as many as the machine has cores.
void setMostThreads(unsigned threads);
/// How many it may use.
unsigned mostThreads();

} // namespace irsg
