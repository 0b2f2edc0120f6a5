#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace irsg {

/// Throws InputError where a model says of itself that more belongs to it than there is: brackets
/// that stay open (.osg, .osgt, .x), a tag that is not closed (.osgx), a piece longer than what is
/// left of the file (.3ds, .lwo), fewer surfaces and vertices than it says (.ac). Plug-ins read
/// what is left of such a file without a word. Formats that cannot tell pass. The bytes are at
/// `place`. Returns a remark where an .ac counts more objects than it has and yet ends behind a
/// whole one: many that are sound do.
std::vector<std::string> checkCompleteness(const std::filesystem::path& place,
                                           const std::filesystem::path& file);

} // namespace irsg
