#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <assimp/IOSystem.hpp>

#include "irsg/core/WrittenPath.h"

namespace irsg {

/// What Assimp may open: the model itself, and beside it what OpenableFiles lists as buffers.
/// Nothing is written.
class AssimpFiles : public Assimp::IOSystem {
  public:
    /// The bytes at `place` are those of `file`.
    AssimpFiles(std::filesystem::path place, std::filesystem::path file)
        : place_(std::move(place)), file_(std::move(file)) {}

    bool Exists(const char* name) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    /// What was not opened, each once.
    const std::vector<std::string>& remarks() const { return remarks_; }

  private:
    WrittenPath find(const std::string& name) const;

    std::filesystem::path place_, file_;
    std::vector<std::string> remarks_;
};

} // namespace irsg
