#include "apps/smat-batch/Streams.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace smat::batch {

namespace {

int problem = 0;

} // namespace

void openStreams() {
    std::signal(SIGPIPE, SIG_IGN);
    // A file that grows beyond what is allowed is refused in words.
    std::signal(SIGXFSZ, SIG_IGN);
    // The lowest number that is free is given out: in this order each gets its own. What is printed
    // to a closed output is lost, and has to be told as such.
    constexpr const char* places[] = {"/dev/null", "/dev/full", "/dev/null"};
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0)
            static_cast<void>(open(places[stream], stream == STDIN_FILENO ? O_RDONLY : O_WRONLY));
}

bool outputFailed() {
    errno = 0;
    if (std::fflush(stdout) != 0 && problem == 0)
        problem = errno;
    if (std::ferror(stdout) != 0 && problem == 0)
        problem = EIO;
    return problem != 0;
}

std::string outputProblem() {
    return std::generic_category().message(problem);
}

} // namespace smat::batch
