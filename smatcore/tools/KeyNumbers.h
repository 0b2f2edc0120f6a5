#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"

namespace smat {

/// A key of a text such as "T_K=700,p_atm=1".
struct NumberKey {
    std::string key;
    bool isNeeded = false;
};

/// Calls set(number of the key, value) for each "KEY=NUMBER" of a text, commas between them. The
/// diagnostics, under the name `name`: unknown keys with the nearest one, keys that are missing or
/// there twice, what is no number. `example`: a key with its number.
std::vector<irsg::Diagnostic> readKeyNumbers(const std::string& text, const std::string& name,
                                             const std::vector<NumberKey>& keys,
                                             const std::string& example,
                                             const std::function<void(std::size_t, double)>& set);

} // namespace smat
