#pragma once

#include <vector>

#include <QObject>

#include "gui/view/PlaceHandles.h"
#include "gui/widgets/Dialogs.h"
#include "smatcore/project/Project.h"

class QWidget;

namespace smat::gui {

class LoadingBar;
class ModelPage;
class SceneLoader;
class SceneView;
class Workbench;

/// The page of the model as the project is: its models are read beside the window, its settings
/// followed, and where a person moves the sensor the project has it, a drag as one step to undo.
class ProjectView : public QObject {
    Q_OBJECT

  public:
    /// `pages` is to hold the page.
    ProjectView(Workbench& workbench, Dialogs& dialogs, LoadingBar& loading, QWidget* pages);

    ModelPage* page() const { return page_; }
    SceneView* view() const;
    /// Of exported pictures: that of the project.
    void followTitle();
    /// Reads the models of the project anew.
    void showModels();
    /// The same where they are others than those that are shown.
    void followModels();
    void followSettings();
    bool isLoading() const;

  signals:
    /// Other models are seen.
    void shown();
    /// For a moment, or until something else is said.
    void said(const QString& sentence, int time_ms);
    /// What was taken for granted in a model, to be kept.
    void remarked(const QString& sentence);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void connectLoader();
    void connectHandles();
    /// The handles of the chosen model; they come where there are several.
    void followHandles();
    void drag(PlaceHandle handle, double change);

    Workbench& workbench_;
    Dialogs& dialogs_;
    ModelPage* page_;
    SceneLoader* loader_;
    std::vector<ProjectModel> shown_;
    std::size_t placeable_ = 1; ///< models there were when handles were shown or hidden last
    double begunAt_ = 0.0;      ///< the value that is dragged
};

} // namespace smat::gui
