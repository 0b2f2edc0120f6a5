#pragma once

#include <filesystem>
#include <string_view>

namespace irsg {

/// A file that is written beside the one it will replace, and takes its place in one step: whoever
/// is killed at any moment leaves the old file or the new one, and at most one hidden neighbour,
/// which the next replacement takes over. Two writers of one file wait for each other.
class FileReplacement {
  public:
    /// Makes the neighbour, empty (".NAME.part" in the same folder). A link is followed. Throws
    /// InputError naming `target` where its folder is missing or cannot be written, where it is a
    /// folder, and where another program keeps writing it for two seconds.
    explicit FileReplacement(const std::filesystem::path& target);
    /// Removes the neighbour, unless it has become the target.
    ~FileReplacement();
    FileReplacement(const FileReplacement&) = delete;
    FileReplacement& operator=(const FileReplacement&) = delete;

    /// Where to write.
    const std::filesystem::path& path() const { return part_; }
    /// Appends to the neighbour. Throws InputError, on a full disk say.
    void write(std::string_view bytes);

    enum class Existing { replace, refuse };
    /// Brings everything to the disk and puts it in place. Throws InputError where that fails, or
    /// where the target exists and is not to be replaced; then it is as it was.
    void commit(Existing existing = Existing::replace);

  private:
    std::filesystem::path named_;  ///< as messages call it
    std::filesystem::path target_; ///< behind a link
    std::filesystem::path part_;
    int descriptor_ = -1;
    bool done_ = false;
};

/// The whole of a file in one step, as above.
void writeFileDurably(const std::filesystem::path& file, std::string_view bytes);

} // namespace irsg
