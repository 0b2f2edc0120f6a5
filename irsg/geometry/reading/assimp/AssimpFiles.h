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
    /// `bytes` are those of `file`, whatever lies under that name.
    AssimpFiles(std::filesystem::path file, std::string bytes)
        : file_(std::move(file)), bytes_(std::move(bytes)) {}

    bool Exists(const char* name) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    /// What was not opened, each once.
    const std::vector<std::string>& remarks() const { return remarks_; }

  private:
    WrittenPath find(const std::string& name) const;

    std::filesystem::path file_;
    std::string bytes_;
    std::vector<std::string> remarks_;
};

} // namespace irsg
