#pragma once

#include <string>
#include <vector>

namespace smat::test {

/// Options of a scene whose light is that of its surfaces alone.
inline const std::vector<std::string> plain = {
    "--sun", "off", "--ambient-reflection", "off", "--bounces", "0", "--shadows", "off"};

inline std::vector<std::string> with(std::vector<std::string> words,
                                     const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

} // namespace smat::test
