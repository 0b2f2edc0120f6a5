#pragma once

#include <functional>
#include <string>

namespace smat::test {

/// What happens to a process at one of its calls of the system, or at one of those of a process
/// that shares its memory until it becomes another program (vfork).
struct Mishap {
    /// Killed is the process itself, whoever calls.
    enum Kind { none, killed, fails } kind = none;
    long call = 0;            ///< which call, from 1
    int error = 0;            ///< of a call that fails
    bool onlyWriting = false; ///< calls count from the first that opens a file for writing
};

/// How the process ended.
struct Ended {
    int exitCode = -1; ///< 0 done, 2 refused, 3 something else; -1 where it was killed
    long calls = 0;    ///< of the system, from the beginning of the work or of writing
    std::string name;  ///< number of the call that met the mishap
};

/// Whether this machine and its rules let one process watch the calls of another.
bool callsCanBeWatched();

/// Does the work in a process of its own, which meets a mishap. Calls that give memory, ask clocks
/// or end the process never fail.
Ended doWatched(const std::function<void()>& work, const Mishap& mishap);

/// Does the work in a process of its own; its exit code.
int doElsewhere(const std::function<void()>& work);

} // namespace smat::test
