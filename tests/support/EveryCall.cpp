#include "tests/support/EveryCall.h"

#include <csignal>
#include <exception>
#include <filesystem>
#include <set>

#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include "irsg/radiometry/Errors.h"

namespace smat::test {

namespace {

[[noreturn]] void workAndEnd(const std::function<void()>& work) {
    try {
        work();
    } catch (const irsg::InputError&) {
        _exit(2);
    } catch (const std::filesystem::filesystem_error&) {
        _exit(2);
    } catch (const std::exception&) {
        _exit(3);
    }
    _exit(0);
}

} // namespace

int doElsewhere(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child == 0)
        workAndEnd(work);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

#if defined(__x86_64__)

namespace {

const std::set<long> never = {SYS_mmap,           SYS_munmap,
                              SYS_mprotect,       SYS_mremap,
                              SYS_madvise,        SYS_brk,
                              SYS_futex,          SYS_exit,
                              SYS_exit_group,     SYS_rt_sigaction,
                              SYS_rt_sigprocmask, SYS_rt_sigreturn,
                              SYS_clock_gettime,  SYS_clock_nanosleep,
                              SYS_gettimeofday,   SYS_getpid,
                              SYS_gettid,         SYS_rseq,
                              SYS_close};

/// Whether a call, on its way in, opens a file that may be written.
bool opensForWriting(const user_regs_struct& registers) {
    const auto writes = [](unsigned long long flags) { return (flags & O_ACCMODE) != O_RDONLY; };
    switch (static_cast<long>(registers.orig_rax)) {
    case SYS_openat:
        return writes(registers.rdx);
    case SYS_open:
        return writes(registers.rsi);
    case SYS_creat:
        return true;
    default:
        return false;
    }
}

} // namespace

Ended doWatched(const std::function<void()>& what, const Mishap& mishap) {
    const pid_t child = fork();
    if (child == 0) {
        if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0)
            _exit(4);
        raise(SIGSTOP);
        workAndEnd(what);
    }
    Ended ended;
    int status = 0;
    waitpid(child, &status, 0);
    if (!WIFSTOPPED(status))
        return ended;
    ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
    bool entering = true, failing = false, counting = !mishap.onlyWriting;
    for (int signal = 0;;) {
        ptrace(PTRACE_SYSCALL, child, nullptr, signal);
        signal = 0;
        if (waitpid(child, &status, 0) != child || WIFEXITED(status) || WIFSIGNALED(status))
            break;
        if (WSTOPSIG(status) != (SIGTRAP | 0x80)) {
            signal = WSTOPSIG(status);
            continue;
        }
        user_regs_struct registers{};
        ptrace(PTRACE_GETREGS, child, nullptr, &registers);
        counting = counting || (entering && opensForWriting(registers));
        if (entering && counting && ++ended.calls == mishap.call) {
            const auto number = static_cast<long>(registers.orig_rax);
            ended.name = std::to_string(number);
            if (mishap.kind == Mishap::killed) {
                kill(child, SIGKILL);
                waitpid(child, &status, 0);
                break;
            }
            if (mishap.kind == Mishap::fails && !never.contains(number)) {
                registers.orig_rax = static_cast<unsigned long long>(-1);
                ptrace(PTRACE_SETREGS, child, nullptr, &registers);
                failing = true;
            }
        } else if (!entering && failing) {
            registers.rax = static_cast<unsigned long long>(-mishap.error);
            ptrace(PTRACE_SETREGS, child, nullptr, &registers);
            failing = false;
        }
        entering = !entering;
    }
    ended.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return ended;
}

bool callsCanBeWatched() {
    const Ended ended = doWatched([] { static_cast<void>(getppid()); }, {});
    return ended.exitCode == 0 && ended.calls > 0;
}

#else

Ended doWatched(const std::function<void()>&, const Mishap&) {
    return {};
}

bool callsCanBeWatched() {
    return false;
}

#endif

} // namespace smat::test
