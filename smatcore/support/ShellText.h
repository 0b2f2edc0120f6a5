#pragma once

#include <string>

namespace smat {

/// In single quotes where a shell would take the word apart.
std::string shellQuoted(const std::string& word);

} // namespace smat
