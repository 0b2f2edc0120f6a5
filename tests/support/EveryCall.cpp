#include "tests/support/EveryCall.h"

#include <cerrno>
#include <csignal>
#include <exception>
#include <filesystem>
#include <map>
#include <set>

#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include "irsg/core/Errors.h"

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
    if (child == 0) {
        workAndEnd(work);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

#if defined(__x86_64__)

namespace {

/// Calls that are let through: what memory, threads, signals and clocks need (sigaltstack: a
/// sanitizer ends the program where that fails).
const std::set<long> never = {SYS_mmap,           SYS_munmap,
                              SYS_mprotect,       SYS_mremap,
                              SYS_madvise,        SYS_brk,
                              SYS_futex,          SYS_exit,
                              SYS_exit_group,     SYS_rt_sigaction,
                              SYS_rt_sigprocmask, SYS_rt_sigreturn,
                              SYS_clock_gettime,  SYS_clock_nanosleep,
                              SYS_gettimeofday,   SYS_getpid,
                              SYS_gettid,         SYS_rseq,
                              SYS_close,          SYS_sigaltstack};

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

/// The processes of one piece of work, from its beginning to the end of the last.
class Watch {
  public:
    Watch(pid_t worker, const Mishap& mishap)
        : worker_(worker), mishap_(mishap), counting_(!mishap.onlyWriting), states_{{worker, {}}} {}

    Ended toTheEnd();

  private:
    struct State {
        bool entering = true;
        int failing = 0; ///< with which error the call in progress fails
    };

    /// To the next call, or to the end where no call matters any more.
    void goOn(pid_t process, int signal = 0) {
        ptrace(hasMet_ ? PTRACE_CONT : PTRACE_SYSCALL, process, nullptr, signal);
    }
    void meetsStop(pid_t process, int status);
    void meetsCall(pid_t process);
    void entersCall(pid_t process, user_regs_struct& registers);
    void letFail(pid_t process, user_regs_struct& registers, int error) {
        registers.orig_rax = static_cast<unsigned long long>(-1);
        ptrace(PTRACE_SETREGS, process, nullptr, &registers);
        states_.at(process).failing = error;
    }

    pid_t worker_;
    const Mishap& mishap_;
    bool counting_;
    bool hasMet_ = false; ///< the mishap, whole
    std::map<pid_t, State> states_;
    Ended ended_;
};

void Watch::entersCall(pid_t process, user_regs_struct& registers) {
    const auto number = static_cast<long>(registers.orig_rax);
    counting_ = counting_ || (process == worker_ && opensForWriting(registers));
    if (!counting_ || ++ended_.calls != mishap_.call) {
        return;
    }
    ended_.name = std::to_string(number);
    if (mishap_.kind == Mishap::killed) {
        kill(worker_, SIGKILL);
    }
    hasMet_ = mishap_.kind != Mishap::fails || never.contains(number);
    if (!hasMet_) {
        letFail(process, registers, mishap_.error);
    }
}

void Watch::meetsCall(pid_t process) {
    State& state = states_.at(process);
    user_regs_struct registers{};
    if (state.entering || state.failing != 0) {
        ptrace(PTRACE_GETREGS, process, nullptr, &registers);
    }
    if (state.entering) {
        entersCall(process, registers);
    } else if (state.failing != 0) {
        registers.rax = static_cast<unsigned long long>(-state.failing);
        ptrace(PTRACE_SETREGS, process, nullptr, &registers);
        state.failing = 0;
        hasMet_ = mishap_.call > 0 && ended_.calls == mishap_.call;
    }
    state.entering = !state.entering;
}

void Watch::meetsStop(pid_t process, int status) {
    const bool isNew = states_.try_emplace(process).second;
    const int signal = WSTOPSIG(status);
    if (signal == (SIGTRAP | 0x80)) {
        meetsCall(process);
        goOn(process);
    } else if (status >> 16 == PTRACE_EVENT_EXEC) {
        // Another program goes its own way.
        ptrace(PTRACE_DETACH, process, nullptr, 0);
        states_.erase(process);
    } else {
        const bool isEvent = status >> 16 != 0 || isNew;
        goOn(process, isEvent ? 0 : signal);
    }
}

Ended Watch::toTheEnd() {
    ptrace(PTRACE_SETOPTIONS, worker_, nullptr,
           PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL | PTRACE_O_TRACEVFORK | PTRACE_O_TRACEEXEC);
    goOn(worker_);
    while (!states_.empty()) {
        int status = 0;
        const pid_t process = waitpid(-1, &status, __WALL);
        if (process < 0) {
            break;
        }
        if (WIFSTOPPED(status)) {
            meetsStop(process, status);
            continue;
        }
        states_.erase(process);
        if (process == worker_) {
            ended_.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        }
    }
    return ended_;
}

} // namespace

Ended doWatched(const std::function<void()>& what, const Mishap& mishap) {
    const pid_t child = fork();
    if (child == 0) {
        if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) {
            _exit(4);
        }
        raise(SIGSTOP);
        workAndEnd(what);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSTOPPED(status) ? Watch(child, mishap).toTheEnd() : Ended();
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
