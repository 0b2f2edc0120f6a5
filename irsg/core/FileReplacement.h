#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace irsg {

/// A file that is written without a name (in memory where the file system knows no files without
/// names) and takes its place in one step: whoever is killed at any moment leaves the old file or
/// the new one and nothing else (atomicRename). After a loss of power in the middle of that step a
/// hidden neighbour (".NAME.XXX.part") may be left; the next program that writes into the folder
/// removes it. Writers of one file do not meet: the last one wins.
class FileReplacement {
  public:
    enum class Input { refuse, allow };
    /// A link is followed. The new file gets owner and permissions of the one that stands. Throws
    /// InputError naming `target` where its folder is missing or cannot be written, and where it is
    /// a folder, no regular file, write-protected, or an input (protectInputs), unless what was
    /// read is what is saved.
    explicit FileReplacement(const std::filesystem::path& target, Input input = Input::refuse);
    /// Leaves nothing behind, unless it was committed.
    ~FileReplacement();
    FileReplacement(const FileReplacement&) = delete;
    FileReplacement& operator=(const FileReplacement&) = delete;

    /// Appends. Throws InputError, on a full disk say.
    void write(std::string_view bytes);

    enum class Existing { replace, refuse };
    /// Brings everything to the disk and puts it in place. Throws InputError where that fails, or
    /// where the target exists and is not to be replaced; then it is as it was.
    void commit(Existing existing = Existing::replace);

  private:
    void takePermissions();
    int linkToTarget() const;
    int atomicRenameToTarget(Existing existing) const;

    std::filesystem::path named_;  ///< as messages call it
    std::filesystem::path target_; ///< behind a link
    bool isOnDiskOfTarget_ = true; ///< else in memory
    int descriptor_ = -1;
};

/// The whole of a file in one step, as above. What is no regular file but may be written (a device,
/// a pipe) is written as it stands.
void writeFileDurably(const std::filesystem::path& file, std::string_view bytes);

} // namespace irsg
