#pragma once

#include <string>
#include <vector>

namespace smat::batch {

/// A file of AtmosphereSmart with the report's values but for those of `assignments`
/// ("Visibility=5000"). Throws InputError for all of them that are wrong at once.
void writeNewAtmosphere(const std::vector<std::string>& assignments, const std::string& out);

/// The file with other values, in `out` or in its own place where that is empty. What else stands
/// in it is kept. Throws InputError as above, and as AtmosphereSmart::fromXml.
void changeAtmosphere(const std::string& file, const std::vector<std::string>& assignments,
                      const std::string& out);

} // namespace smat::batch
