#pragma once

#include <string>

namespace smat::test {

/// What this process holds, but for the threads of Qt's pools and the one file that each of them
/// opens: a pool begins and ends its few threads when it likes.
struct ProcessCounts {
    int threads = 0;
    int files = 0;
};

/// Of /proc/self, now.
ProcessCounts processCounts();

/// What they are, one a line: "17 -> anon_inode:[eventfd]", and the names of the threads.
std::string openFiles();

} // namespace smat::test
