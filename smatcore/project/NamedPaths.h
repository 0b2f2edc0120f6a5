#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/core/WrittenPath.h"
#include "smatcore/project/Project.h"

namespace smat {

/// What a path in a project or a scenario means, seen from the file that it stands in (the working
/// folder where that is empty), with the remark of irsg::findWritten. What lies nowhere but came
/// with the program is that (shippedFile), with a remark. Where nothing is found it is the path as
/// it is written.
irsg::WrittenPath namedPath(const std::filesystem::path& document,
                            const std::filesystem::path& path);

/// A sentence for each model, database and file of the settings that is read under another name
/// than the one that is written.
std::vector<std::string> remarksOnNames(const Project& project, const Settings& settings);

} // namespace smat
