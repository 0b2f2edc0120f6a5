#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/core/WrittenPath.h"

namespace irsg {

/// What a name in a file was found to stand for, seen from a folder.
struct FoundName {
    std::filesystem::path folder;
    std::string written;
    WrittenPath found;
};

/// While an object lives, what findWrittenOrBeside() finds on this thread is kept, too.
class FoundNames {
  public:
    FoundNames();
    ~FoundNames();
    FoundNames(const FoundNames&) = delete;
    FoundNames& operator=(const FoundNames&) = delete;

    std::vector<FoundName> take();

  private:
    FoundNames* outer_;
    std::vector<FoundName> names_;
    friend void noteFound(const std::filesystem::path&, const std::string&, const WrittenPath&);
};

/// From now on findWrittenOrBeside() answers from these alone: for a process that may not look
/// into folders.
void useFoundNames(std::vector<FoundName> names);

} // namespace irsg
