#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace smat {

/// The names that a mistyped word may have been meant for: those with the fewest edits to it
/// (Damerau-Levenshtein: letters inserted, left out, replaced, or two neighbours swapped), at most
/// one edit for every three letters, upper case or lower. A name with dots, "sensor.fov", is also
/// compared by its last part. Where no name is so near, those that begin with the word. At most
/// three, in their order; none for a word without letters.
std::vector<std::string> nearestNames(std::string_view word, const std::vector<std::string>& names);

/// The same as the end of a message: "; did you mean 'polar' or 'range'?", "" where no name is
/// near.
std::string didYouMean(std::string_view word, const std::vector<std::string>& names);

/// What is expected in place of a word that is none of the names: "one of polar, range, time; did
/// you mean 'polar'?".
std::string oneOf(const std::vector<std::string>& names, std::string_view word);

} // namespace smat
