#include "irsg/core/AtomicRename.h"

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <memory>

#include <fcntl.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace irsg {

namespace {

/// What the process that takes the name and its caller share.
struct Errand {
    const AtomicRename& taking;
    bool isDone = false;
    bool isSecondTime = false; ///< the first was cut off
    int error = 0;
    bool isNamed = false; ///< the file has the name of the neighbour, or had it
    dev_t device = 0;     ///< of the file that was named
    ino_t inode = 0;
};

// Below nothing may allocate or throw: other threads of the caller stand still wherever they were.

int copied(const AtomicRename& taking, int to) {
    char block[16 * 1024];
    for (off_t at = 0;;) {
        const ssize_t count = pread(taking.descriptor, block, sizeof block, at);
        if (count == 0)
            return 0;
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return errno;
        for (ssize_t done = 0; done < count;) {
            const ssize_t more = write(to, block + done, static_cast<std::size_t>(count - done));
            if (more < 0 && errno != EINTR)
                return errno;
            done += more < 0 ? 0 : more;
        }
        at += count;
    }
}

/// A copy of the file as the hidden neighbour, on the disk.
int copyAsPart(Errand& errand) {
    const AtomicRename& taking = errand.taking;
    const int part = open(taking.part, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (part < 0)
        return errno;
    errand.isNamed = true;
    // Whoever sweeps leaves alone what is locked.
    static_cast<void>(flock(part, LOCK_EX | LOCK_NB));
    if (taking.old) {
        // Who may not give files away keeps his own.
        static_cast<void>(!fchown(part, taking.old->st_uid, taking.old->st_gid));
        static_cast<void>(fchmod(part, taking.old->st_mode & 07777));
    }
    int error = copied(taking, part);
    if (error == 0 && fsync(part) != 0)
        error = errno;
    close(part);
    return error;
}

int nameAsPart(Errand& errand) {
    const AtomicRename& taking = errand.taking;
    if (!taking.isOnDiskOfTarget)
        return copyAsPart(errand);
    // A file that had a name and lost it gets none again: what was linked stays so.
    if (linkat(AT_FDCWD, taking.calling, AT_FDCWD, taking.part, AT_SYMLINK_FOLLOW) != 0 &&
        !(errand.isSecondTime && errno == EEXIST))
        return errno;
    errand.isNamed = true;
    return 0;
}

int moveToTarget(const AtomicRename& taking) {
    if (!taking.mayReplace) {
        if (renameat2(AT_FDCWD, taking.part, AT_FDCWD, taking.target, RENAME_NOREPLACE) == 0)
            return 0;
        // Some file systems cannot tell in one step.
        if (errno != EINVAL)
            return errno;
        struct stat there {};
        if (lstat(taking.target, &there) == 0)
            return EEXIST;
    }
    return rename(taking.part, taking.target) == 0 ? 0 : errno;
}

void carryOut(Errand& errand) {
    const AtomicRename& taking = errand.taking;
    int error = nameAsPart(errand);
    struct stat named {};
    if (error == 0 && stat(taking.part, &named) != 0)
        error = errno;
    errand.device = named.st_dev;
    errand.inode = named.st_ino;
    if (error == 0)
        error = moveToTarget(taking);
    if (error != 0 && errand.isNamed)
        unlink(taking.part);
    errand.error = error;
    errand.isDone = true;
}

int carryOutApart(void* errand) {
    // Who ends all processes of a terminal or a group does not mean this one.
    setpgid(0, 0);
    carryOut(*static_cast<Errand*>(errand));
    return 0;
}

bool isInPlace(const Errand& errand) {
    struct stat there {};
    return errand.inode != 0 && stat(errand.taking.target, &there) == 0 &&
           there.st_dev == errand.device && there.st_ino == errand.inode;
}

} // namespace

int atomicRename(const AtomicRename& taking) {
    constexpr std::size_t stackSize = 256 * 1024;
    const std::unique_ptr<std::byte[]> stack(new std::byte[stackSize]);
    Errand errand{taking};
    // The other process shares this one's memory; none of this one's handlers may run there.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    // Its end is told to nobody by a signal, and this thread stands still until then.
    const int child =
        clone(carryOutApart, stack.get() + stackSize, CLONE_VM | CLONE_VFORK, &errand);
    if (child < 0) {
        carryOut(errand);
    } else {
        while (waitpid(child, nullptr, __WALL) < 0 && errno == EINTR) {
        }
        if (!errand.isDone && !isInPlace(errand)) {
            // It was killed; half a copy is of no use.
            if (!taking.isOnDiskOfTarget)
                unlink(taking.part);
            errand.isSecondTime = true;
            carryOut(errand);
        }
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return errand.error;
}

} // namespace irsg
