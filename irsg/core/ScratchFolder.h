#pragma once

#include <filesystem>
#include <string>

namespace irsg {

/// Where temporary files go: $TMPDIR, or /tmp. Throws InputError where they cannot, which expects a
/// folder "for " and `what`.
std::filesystem::path scratchPlace(const std::string& what);

/// A new folder there that this user alone can look into. It goes with its owner, with all that is
/// in it.
class ScratchFolder {
  public:
    /// Throws InputError where none can be made.
    explicit ScratchFolder(const std::string& what);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(const std::filesystem::path& name) const {
        return folder_ / name;
    }

  private:
    std::filesystem::path folder_;
};

} // namespace irsg
