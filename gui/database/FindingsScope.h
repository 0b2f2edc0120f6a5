#pragma once

#include <optional>

#include <QTimer>

#include "gui/database/EditorContext.h"
#include "gui/widgets/LatestTask.h"

namespace smat::gui {

/// What the database that is edited is checked against: as `smat-batch db lint --project` does it,
/// all models of the project that name it with the scales beside them, the bands of its analyses
/// and every state that they take. Gathered beside the window, and anew a moment after the project
/// has changed; until then the target, its band and its scales are what counts.
class FindingsScope : public QObject {
    Q_OBJECT

  public:
    explicit FindingsScope(EditorContext& context, QObject* parent = nullptr);

    /// What the physics finds in the database as it stands, its file's scales included. LogicError
    /// where no database is open.
    std::vector<irsg::Finding> findings() const;

  signals:
    /// findings() may have another answer, though nothing was edited.
    void changed();

  private:
    /// `scope` has the models of these files, in their order.
    struct Surroundings {
        irsg::LintScope scope;
        std::vector<std::filesystem::path> modelFiles;
    };
    static Surroundings gather(const Project& project, const std::filesystem::path& database,
                               const std::shared_ptr<ModelStore>& models);
    Surroundings ofTargetAlone() const;
    void forget();
    void ask();

    EditorContext& context_;
    QTimer delay_;
    LatestTask gathering_;
    std::optional<Surroundings> gathered_;
};

} // namespace smat::gui
