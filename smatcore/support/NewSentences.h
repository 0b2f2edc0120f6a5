#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace smat {

/// Adds the sentences that are not among the others yet.
inline void addNew(std::vector<std::string>& sentences, const std::vector<std::string>& more) {
    for (const std::string& sentence : more)
        if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end())
            sentences.push_back(sentence);
}

} // namespace smat
