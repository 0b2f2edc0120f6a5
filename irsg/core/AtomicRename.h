#pragma once

struct stat;

namespace irsg {

/// A whole file without a name, and the name that it is to have.
struct AtomicRename {
    int descriptor;         ///< of the file
    bool isOnDiskOfTarget;  ///< on its file system, where a link is a name; else it is copied
    const char* calling;    ///< what the system calls the file ("/proc/self/fd/N")
    const char* part;       ///< a hidden neighbour of the target, which nothing has as its name
    const char* target;     ///< takes the file
    const struct stat* old; ///< whose owner and permissions a copy gets; null: those of a new file
    bool mayReplace;        ///< else a target that exists is EEXIST
};

/// Puts the file in place of the target: 0, or what the system says (errno); then the target is as
/// it was and nothing is beside it.
///
/// No call of the system puts a file without a name in place of another: it takes a name of its own
/// first, and who is killed before the next call leaves it there. Therefore a process of its own
/// makes these calls, which goes on where the caller is killed, and after which the caller clears
/// up where it is killed itself. The name stays only where both end between two calls (a loss of
/// power, say).
int atomicRename(const AtomicRename& taking);

} // namespace irsg
