#include "tests/gui/ProcessCounts.h"

#include <filesystem>
#include <fstream>
#include <string>

namespace smat::test {

ProcessCounts processCounts() {
    namespace fs = std::filesystem;
    ProcessCounts counts;
    const fs::directory_iterator files("/proc/self/fd");
    counts.files = static_cast<int>(std::distance(begin(files), end(files)));
    for (const auto& task : fs::directory_iterator("/proc/self/task")) {
        std::string name;
        std::ifstream comm(task.path() / "comm");
        std::getline(comm, name);
        if (name == "Thread (pooled)")
            --counts.files;
        else
            ++counts.threads;
    }
    return counts;
}

} // namespace smat::test
