#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <QObject>
#include <QTimer>

#include "gui/start/RecoverySlot.h"
#include "smatcore/project/Project.h"

namespace smat::gui {

class Workbench;

/// Keeps what is not saved beside the project's file, `ship.smat.recovery` beside `ship.smat`,
/// never over it: written some seconds after an edit, removed when nothing is unsaved any more. A
/// project without a file has its copy in the user's data folder. A crash leaves the copy behind.
/// A copy that another run left behind, or that another window keeps, is never written over: the
/// next one lies beside it as `ship.smat.2.recovery`.
class RecoveryCopy : public QObject {
    Q_OBJECT

  public:
    RecoveryCopy(Workbench& workbench, int delay_s, QObject* parent = nullptr);
    ~RecoveryCopy() override;

    void setDelay(int delay_s);
    /// Writes now what the timer would write later.
    void writeNow();
    /// Takes the copy away: the changes were thrown away by the person who made them.
    void forget();

    /// Goes on with a copy that was left behind, whose project is the one that is open now.
    void takeOver(const std::filesystem::path& copy);

    /// Where the copy of a project's file lies, from 1; an empty name means a project without a
    /// file.
    static std::filesystem::path pathFor(const std::filesystem::path& projectFile, int number = 1);
    /// The copies that were left behind and that no window that still runs is at work on, the
    /// newest first.
    static std::vector<std::filesystem::path> leftBehind(const std::filesystem::path& projectFile);
    /// Whether another window that still runs keeps unsaved changes of this file.
    static bool isInUse(const std::filesystem::path& projectFile);
    /// What a copy holds, as the project of `projectFile`. Throws irsg::InputError.
    static Project read(const std::filesystem::path& copy,
                        const std::filesystem::path& projectFile);

  signals:
    /// The copy cannot be written: said once per project.
    void failed(const QString& sentence);

  private:
    void onModifiedChanged();
    void onProjectChanged();
    void write();

    Workbench& workbench_;
    QTimer timer_;
    std::optional<std::filesystem::path> file_; ///< of the project whose copy this is
    RecoverySlot slot_;
    bool told_ = false;
};

} // namespace smat::gui
