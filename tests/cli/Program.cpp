#include "tests/cli/Program.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace smat::test {

namespace {

/// Both ends of a pipe; the child's end goes with the child.
struct Pipe {
    int read = -1, write = -1;
    Pipe() {
        int ends[2];
        if (pipe(ends) != 0) {
            throw std::runtime_error("no pipe can be made");
        }
        read = ends[0];
        write = ends[1];
    }
};

[[noreturn]] void become(std::vector<std::string> words, const std::filesystem::path& folder,
                         const Pipe& out, const Pipe& err) {
    dup2(out.write, STDOUT_FILENO);
    dup2(err.write, STDERR_FILENO);
    for (const int end : {out.read, out.write, err.read, err.write}) {
        close(end);
    }
    if (chdir(folder.c_str()) != 0) {
        _exit(126);
    }
    std::vector<char*> raw;
    for (std::string& word : words) {
        raw.push_back(word.data());
    }
    raw.push_back(nullptr);
    execvp(raw.front(), raw.data());
    _exit(127);
}

} // namespace

Ran smatBatch(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
              const std::string& interruptAfter, int signal) {
    std::vector<std::string> words = {SMAT_BATCH};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return runProgram(words, folder, interruptAfter, signal);
}

Ran runProgram(const std::vector<std::string>& words, const std::filesystem::path& folder,
               const std::string& interruptAfter, int signal) {
    const Pipe out, err;
    const pid_t child = fork();
    if (child == 0) {
        become(words, folder, out, err);
    }
    close(out.write);
    close(err.write);

    // Both streams are emptied as they fill, so that neither can block the program.
    Ran ran;
    bool interrupted = interruptAfter.empty();
    pollfd ends[2] = {{out.read, POLLIN, 0}, {err.read, POLLIN, 0}};
    std::string* texts[2] = {&ran.out, &ran.err};
    for (int open = 2; open > 0;) {
        poll(ends, 2, -1);
        for (int i = 0; i < 2; ++i) {
            if ((ends[i].revents & (POLLIN | POLLHUP)) == 0) {
                continue;
            }
            char buffer[4096];
            const ssize_t count = read(ends[i].fd, buffer, sizeof buffer);
            if (count <= 0) {
                close(ends[i].fd);
                ends[i].fd = -1;
                --open;
                continue;
            }
            texts[i]->append(buffer, static_cast<std::size_t>(count));
            if (!interrupted && ran.err.find(interruptAfter) != std::string::npos) {
                kill(child, signal);
                interrupted = true;
            }
        }
    }
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    for (const timeval& part : {used.ru_utime, used.ru_stime}) {
        ran.processor_s +=
            static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
    }
    ran.peak_MB = static_cast<double>(used.ru_maxrss) / 1024.0;
    ran.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ran;
}

std::filesystem::path sample(const std::string& name) {
    return std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / name;
}

std::string contentOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string withoutCommand(const std::filesystem::path& file) {
    std::string text = contentOf(file);
    const std::size_t begin = text.find("# command: ");
    return begin == std::string::npos ? text
                                      : text.erase(begin, text.find('\n', begin) + 1 - begin);
}

void write(const std::filesystem::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
}

} // namespace smat::test
