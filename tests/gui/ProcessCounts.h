#pragma once

#include <string>

namespace smat::test {

/// What this process holds, but for the threads of Qt's pools and for events, of which each thread
/// opens one: a pool begins and ends its few threads when it likes, and a thread that has closed
/// its event may be there for a moment more.
struct ProcessCounts {
    int threads = 0;
    int files = 0;
};

/// Of /proc/self, now.
ProcessCounts processCounts();

/// What this program allocated and has not freed [kB]; not what a heap keeps for the next time, as
/// resident pages would count it. 0 under the address sanitizer, which finds leaks by itself.
double allocated_kB();

/// What the counted are, one a line: "17 -> anon_inode:[eventfd]", and the names of the threads.
std::string openFiles();

} // namespace smat::test
