#include "tests/gui/ProcessCounts.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <malloc.h>

namespace smat::test {

namespace fs = std::filesystem;

namespace {

/// Of a thread in /proc/self/task; empty when it has ended meanwhile.
std::string nameOf(const fs::path& task) {
    std::string name;
    std::ifstream comm(task / "comm");
    std::getline(comm, name);
    return name;
}

} // namespace

ProcessCounts processCounts() {
    ProcessCounts counts;
    for (const auto& file : fs::directory_iterator("/proc/self/fd")) {
        std::error_code gone;
        counts.files += fs::read_symlink(file.path(), gone) != "anon_inode:[eventfd]";
    }
    for (const auto& task : fs::directory_iterator("/proc/self/task")) {
        counts.threads += nameOf(task.path()) != "Thread (pooled)";
    }
    return counts;
}

double allocated_kB() {
    const auto heaps = mallinfo2();
    return static_cast<double>(heaps.uordblks + heaps.hblkhd) / 1024.0;
}

std::string openFiles() {
    std::string list;
    for (const auto& file : fs::directory_iterator("/proc/self/fd")) {
        std::error_code gone;
        const fs::path target = fs::read_symlink(file.path(), gone);
        list += file.path().filename().string() + " -> " + target.string() + "\n";
    }
    for (const auto& task : fs::directory_iterator("/proc/self/task")) {
        list += "thread " + nameOf(task.path()) + "\n";
    }
    return list;
}

} // namespace smat::test
