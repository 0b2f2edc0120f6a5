#include "irsg/geometry/reading/sandbox/ReadingLimits.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

// Measured on whole models of a million facets: the plug-ins of text formats take up to 30 times
// the size of a file and 0.4 s for a megabyte.
constexpr std::uint64_t memoryAlways_B = 256u << 20, memoryEach = 48;
constexpr double processorAlways_s = 1.5, processorEach_s_per_B = 2e-6;
constexpr std::uint64_t memoryAtMost_B = std::uint64_t{16} << 30;

// The tools that look for faults in programs need memory of their own, hundreds of times of ours.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool memoryIsLimited = false;
constexpr double slowness = 10.0;
#else
constexpr bool memoryIsLimited = true;
constexpr double slowness = 1.0;
#endif

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
#error "the calls of this architecture have to be listed here before models can be read apart"
#endif

/// What a program needs that reads files and computes.
constexpr int allowedCalls[] = {
    // files that are open, and names
    SYS_read, SYS_pread64, SYS_readv, SYS_write, SYS_writev, SYS_close, SYS_lseek, SYS_fstat,
    SYS_newfstatat, SYS_statx, SYS_faccessat, SYS_faccessat2, SYS_getdents64, SYS_readlinkat,
    SYS_getcwd, SYS_fadvise64,
#if defined(__x86_64__)
    SYS_stat, SYS_lstat, SYS_access, SYS_readlink, SYS_arch_prctl,
#endif
    // memory
    SYS_mmap, SYS_munmap, SYS_mprotect, SYS_mremap, SYS_madvise, SYS_brk, SYS_getrlimit,
    SYS_setrlimit,
    // the process itself
    SYS_exit, SYS_exit_group, SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn,
    SYS_sigaltstack, SYS_futex, SYS_sched_yield, SYS_sched_getaffinity, SYS_getpid, SYS_gettid,
    SYS_getuid, SYS_geteuid, SYS_getgid, SYS_getegid, SYS_set_robust_list, SYS_uname, SYS_sysinfo,
    SYS_getrandom, SYS_getrusage, SYS_times,
#if defined(SYS_rseq)
    SYS_rseq,
#endif
    // clocks
    SYS_clock_gettime, SYS_clock_getres, SYS_gettimeofday, SYS_nanosleep, SYS_clock_nanosleep,
    SYS_setitimer};

constexpr std::uint32_t refusal = SECCOMP_RET_ERRNO | (EPERM & SECCOMP_RET_DATA);

sock_filter statement(std::uint16_t code, std::uint32_t value) {
    return BPF_STMT(code, value);
}
sock_filter jump(std::uint16_t code, std::uint32_t value, std::uint8_t then, std::uint8_t other) {
    return BPF_JUMP(code, value, then, other);
}

/// Opening for anything but reading is refused: by the flags, in argument `place`.
void addOpening(std::vector<sock_filter>& filter, int call, std::size_t place) {
    constexpr std::uint32_t changing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | O_APPEND;
    const auto offset = static_cast<std::uint32_t>(offsetof(seccomp_data, args) + 8 * place);
    filter.push_back(jump(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 4));
    filter.push_back(statement(BPF_LD | BPF_W | BPF_ABS, offset));
    filter.push_back(jump(BPF_JMP | BPF_JSET | BPF_K, changing, 0, 1));
    filter.push_back(statement(BPF_RET | BPF_K, refusal));
    filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
}

sock_filter argument(std::size_t place) {
    return statement(BPF_LD | BPF_W | BPF_ABS,
                     static_cast<std::uint32_t>(offsetof(seccomp_data, args) + 8 * place));
}

/// A call that names a process by its first argument, which must be this one.
void addOfItself(std::vector<sock_filter>& filter, int call, pid_t itself) {
    filter.push_back(jump(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 4));
    filter.push_back(argument(0));
    filter.push_back(jump(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(itself), 1, 0));
    filter.push_back(statement(BPF_RET | BPF_K, refusal));
    filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
}

/// What is done to an open file, but for what has signals sent to others.
void addControl(std::vector<sock_filter>& filter) {
    constexpr std::uint32_t signalling[] = {F_SETOWN, F_SETOWN_EX, F_SETSIG, F_SETLEASE, F_NOTIFY};
    constexpr auto count = static_cast<std::uint8_t>(std::size(signalling));
    filter.push_back(jump(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(SYS_fcntl), 0,
                          static_cast<std::uint8_t>(count + 3)));
    filter.push_back(argument(1));
    for (std::uint8_t i = 0; i < count; ++i)
        filter.push_back(jump(BPF_JMP | BPF_JEQ | BPF_K, signalling[i],
                              static_cast<std::uint8_t>(count - i), 0));
    filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    filter.push_back(statement(BPF_RET | BPF_K, refusal));
}

std::vector<sock_filter> makeFilter() {
    std::vector<sock_filter> filter = {
        statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
        jump(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0),
        statement(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
        statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
    addOpening(filter, SYS_openat, 2);
#if defined(__x86_64__)
    addOpening(filter, SYS_open, 1);
#endif
    addOfItself(filter, SYS_tgkill, getpid());
    addOfItself(filter, SYS_prlimit64, 0); // the C library's number for itself
    addControl(filter);
    for (const int call : allowedCalls) {
        filter.push_back(jump(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1));
        filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    }
    filter.push_back(statement(BPF_RET | BPF_K, refusal));
    return filter;
}

void limit(__rlimit_resource which, rlim_t soft, rlim_t hard) {
    rlimit old{};
    getrlimit(which, &old);
    const rlimit wanted{std::min(soft, old.rlim_max), std::min(hard, old.rlim_max)};
    if (setrlimit(which, &wanted) != 0)
        throw LogicError("a limit of this process cannot be set");
}

std::uint64_t allowedMemory_B = 0;

void setMemory() {
    if (memoryIsLimited)
        limit(RLIMIT_DATA, std::min(allowedMemory_B, memoryAtMost_B), memoryAtMost_B);
}

void setClock(double seconds) {
    const double whole = std::floor(seconds);
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(whole);
    timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - whole) * 1e6);
    setitimer(ITIMER_PROF, &timer, nullptr);
}

} // namespace

ReadingLimits ReadingLimits::of(std::uint64_t file_B) {
    return {memoryAlways_B + memoryEach * file_B,
            slowness * (processorAlways_s + processorEach_s_per_B * static_cast<double>(file_B))};
}

void shutIn() {
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, 0, 0);
    limit(RLIMIT_NOFILE, 256, 256);
    std::vector<sock_filter> filter = makeFilter();
    const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
        throw LogicError("this system does not let a process give up what it does not need");
}

void allow(const ReadingLimits& limits) {
    allowedMemory_B = limits.memory_B;
    setMemory();
    setClock(limits.processor_s);
}

void allowMore(std::uint64_t file_B) {
    allowBytes(memoryEach * file_B);
}

void allowBytes(std::uint64_t memory_B) {
    allowedMemory_B += memory_B;
    setMemory();
}

void stopClock() {
    setClock(0.0);
}

} // namespace irsg
