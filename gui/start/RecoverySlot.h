#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <QString>

class QLockFile;

namespace smat::gui {

/// Where a copy of unsaved edits lies: `NAME.recovery` beside what is edited, locked as long as a
/// window is at work on it. A copy that another run left behind, or that another window keeps, is
/// never written over: the next one lies beside it as `NAME.2.recovery`. A crash leaves copies
/// behind. The base that all is asked for is the path of `NAME`, see placeForUnsaved.
class RecoverySlot {
  public:
    RecoverySlot();
    ~RecoverySlot();

    /// The place of this slot's copy: the one it has, or the first where none lies, which is
    /// locked then. Throws irsg::InputError where there is none.
    const std::filesystem::path& claim(const std::filesystem::path& base);
    /// Goes on with a copy that was left behind; false where another window does already.
    bool takeOver(const std::filesystem::path& copy);
    /// The copy is there now, so that forget() takes it away.
    void setWritten() { isWritten_ = true; }
    /// Takes the copy away, with its lock.
    void forget();

    static std::filesystem::path placeOf(const std::filesystem::path& base, int number = 1);
    /// The copies that were left behind and that no window that still runs is at work on, the
    /// newest first.
    static std::vector<std::filesystem::path> leftBehind(const std::filesystem::path& base);
    /// Whether a window that still runs keeps unsaved edits of it.
    static bool isInUse(const std::filesystem::path& base);
    static void remove(const std::filesystem::path& copy);

  private:
    std::filesystem::path copy_; ///< while there is a lock
    std::unique_ptr<QLockFile> lock_;
    bool isWritten_ = false;
};

/// When a copy was written, in the words of the place.
QString whenWritten(const std::filesystem::path& copy);

} // namespace smat::gui
