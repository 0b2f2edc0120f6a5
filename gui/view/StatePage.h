#pragma once

#include <QWidget>

#include "gui/widgets/Exportable.h"
#include "smatcore/project/Project.h"
#include "smatcore/project/SceneBuilder.h"

class QLabel;
class QToolButton;

namespace smat::gui {

class ColorBar;
class SceneLoader;
class SceneView;
class Workbench;

/// The model as it was when the page came to be: settings, models and signature databases stay
/// while the project is edited further. While the cameras are linked, at first, this view and that
/// of the project turn together, and this one has the display, the colours and the limits of the
/// other, so that a difference in colour is one of the states.
class StatePage : public QWidget, public Exportable {
    Q_OBJECT

  public:
    /// Of the project that is open, as `live` shows it; `name` says which state it is.
    StatePage(Workbench& workbench, SceneView& live, const QString& name,
              QWidget* parent = nullptr);

    SceneView* view() const { return view_; }
    const QString& name() const { return name_; }
    bool isLinked() const;
    bool isLoading() const;

    /// .png: the view as it is seen.
    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  private:
    void layOut();
    void takeState(SceneBuilder::DatabaseOverrides databases);
    void followLive();
    void followColors();

    SceneView& live_;
    QString name_;
    Project project_; ///< with the settings in effect
    SceneView* view_ = nullptr;
    SceneLoader* loader_ = nullptr;
    QToolButton* link_ = nullptr;
    QLabel* problem_ = nullptr;
    bool isFollowing_ = false;
};

} // namespace smat::gui
