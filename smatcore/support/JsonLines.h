#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smat {

/// Where the values of a JSON text stand, by key path ("models.0.file"), so that errors about
/// values can name a line; and the keys that occur twice in one object, which JSON libraries pass
/// silently. The text must be valid JSON.
class JsonLines {
  public:
    explicit JsonLines(std::string_view text);

    /// Counts from 1; 0 for a path that is not there.
    int line(const std::string& path) const;
    /// Key path and line of every second occurrence.
    const std::vector<std::pair<std::string, int>>& duplicates() const { return duplicates_; }

  private:
    std::map<std::string, int> lines_;
    std::vector<std::pair<std::string, int>> duplicates_;
};

/// The line of a byte of a text, from 1.
int lineOfByte(std::string_view text, std::size_t byte);

/// The first byte of a JSON text at which more than `depth` lists and objects are open, or npos.
std::size_t byteOfNesting(std::string_view text, int depth);

/// "models" + "0" -> "models.0"; an empty part adds nothing.
std::string joinedKeyPath(const std::string& path, const std::string& key);

} // namespace smat
