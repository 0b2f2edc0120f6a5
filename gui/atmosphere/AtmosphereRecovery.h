#pragma once

#include <filesystem>
#include <vector>

#include <QObject>
#include <QTimer>

#include "gui/start/RecoverySlot.h"

namespace smat::gui {

class AtmosphereDocument;

/// Keeps unsaved edits of an air beside its file, `air.xml.recovery`, and those of air without a
/// file in the person's own data: written a moment after an edit that can be air, taken away when
/// nothing is unsaved any more. A crash leaves the copy behind.
class AtmosphereRecovery : public QObject {
    Q_OBJECT

  public:
    explicit AtmosphereRecovery(AtmosphereDocument& document, QObject* parent = nullptr);

    /// Writes now what the timer would write later.
    void writeNow();
    /// The edits were given up by the person who made them.
    void forget();
    /// Takes the edits of a copy that was left behind, and goes on with it. Throws
    /// irsg::InputError.
    void takeOver(const std::filesystem::path& copy);

    /// The copies that no window that still runs is at work on, the newest first; of an empty name
    /// those of air that never had a file.
    static std::vector<std::filesystem::path> leftBehind(const std::filesystem::path& file);

  signals:
    /// The copy cannot be written: said once.
    void failed(const QString& sentence);

  private:
    void follow();

    AtmosphereDocument& document_;
    QTimer timer_;
    RecoverySlot slot_;
    std::filesystem::path file_; ///< whose copy this is
    bool isTold_ = false;
};

} // namespace smat::gui
