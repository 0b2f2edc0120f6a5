#pragma once

#include <string>
#include <vector>

namespace irsg {

/// Throws the InputError of a model of which nothing can be seen, with all that its reader left out
/// and said of it: there the cause is.
[[noreturn]] void refuseWithoutFaces(const std::string& file,
                                     const std::vector<std::string>& remarks);

} // namespace irsg
