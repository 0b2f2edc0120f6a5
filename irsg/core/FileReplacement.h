#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace irsg {

/// A file that is written as a hidden neighbour of its place (".NAME.smat-0.part") and takes it in
/// one step: whoever is killed at any moment leaves the old file or the new one, whole. The
/// neighbour may be left over; the next writer of the file removes it. Writers of one file do not
/// meet: the last one wins.
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
    void removePart();

    std::filesystem::path named_;  ///< as messages call it
    std::filesystem::path target_; ///< behind a link
    std::filesystem::path part_;   ///< the hidden neighbour
    int descriptor_ = -1;          ///< of it
    bool isCommitted_ = false;
};

/// The whole of a file in one step, as above. What is no regular file but may be written (a device,
/// a pipe) is written as it stands.
void writeFileDurably(const std::filesystem::path& file, std::string_view bytes);

/// All bytes to an open descriptor, or the InputError of a file `named`.
void writeAll(int descriptor, std::string_view bytes, const std::filesystem::path& named);

/// Throws the InputError that writeFileDurably(file) would end with, as far as it can be foreseen:
/// for who works long before writing. Leaves everything as it was.
void checkWritable(const std::filesystem::path& file);
/// The same of a new file in a folder that exists; `named` is what messages call it.
void checkFolderWritable(const std::filesystem::path& folder, const std::filesystem::path& named);

} // namespace irsg
