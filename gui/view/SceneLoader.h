#pragma once

#include <QStringList>

#include "gui/view/DisplayScene.h"
#include "gui/widgets/LatestTask.h"
#include "gui/workbench/ModelWait.h"

namespace smat::gui {

/// Reads the models of a project for the view in a thread of the pool, so that the window stays
/// alive however large they are. A project that is asked for while another one is being read
/// supersedes it: of the first nothing is heard any more. Nothing is drawn here, so no GL object
/// comes to be.
class SceneLoader : public ModelWait {
    Q_OBJECT

  public:
    explicit SceneLoader(std::shared_ptr<ModelStore> models, QObject* parent = nullptr);

    /// Returns at once; one of loaded and failed follows.
    void load(const Project& project, const Settings& settings);
    bool isBusy() const override { return task_.isBusy(); }

  signals:
    void loaded(std::shared_ptr<smat::gui::DisplayScene> scene);
    void failed(const QStringList& sentences);

  private:
    void letGo() override { task_.cancel(); }

    std::shared_ptr<ModelStore> models_;
    LatestTask task_;
};

} // namespace smat::gui
