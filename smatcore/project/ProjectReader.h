#pragma once

#include <string>

#include "smatcore/project/JsonFields.h"
#include "smatcore/project/Project.h"

namespace smat {

/// Reads the parts of a `.smat` file and collects what is wrong with them (used by ProjectFile
/// alone). Keys nobody asks for end up in the `unknownKeys` of the part they stand in.
class ProjectReader : private JsonFields {
  public:
    ProjectReader(std::string fileName, const std::string& text);

    /// Throws InputError with everything that was wrong.
    Project read();

  private:
    void readModels(Project& project);
    ProjectModel readModel(const Json& json, const std::string& path);
    void refuseOwnOfTarget(const Json& json, const std::string& path);
    void readAnalyses(Project& project);
    NamedAnalysis readAnalysis(const std::string& name, const Json& json, const std::string& path);
};

} // namespace smat
