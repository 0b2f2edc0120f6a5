#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace irsg {

/// Counts records of an .fbx from which no polygon is read, or that would change some.
class FbxRecords {
  public:
    /// An object by its kind ("Geometry") and its class ("Mesh").
    void addObject(std::string_view kind, std::string_view ofClass);
    /// A record in a geometry.
    void addOfGeometry(std::string_view name);
    /// A property of a model that is 0.
    void addZero(std::string_view property);
    std::vector<std::string> remarks() const;

  private:
    std::map<std::string, long> counts_; ///< by sentence, which follows the number
};

/// The same of a file that is a text.
FbxRecords fbxRecordsOfText(std::string_view text);

} // namespace irsg
