#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include "gui/LatestTask.h"
#include "gui/view/DisplayScene.h"

namespace smat::gui {

/// Reads the models of a project for the view in a thread of the pool, so that the window stays
/// alive however large they are. A project that is asked for while another one is being read
/// supersedes it: of the first nothing is heard any more. Nothing is drawn here, so no GL object
/// comes to be.
class SceneLoader : public QObject {
    Q_OBJECT

  public:
    explicit SceneLoader(std::shared_ptr<ModelStore> models, QObject* parent = nullptr);

    /// Returns at once; one of loaded and failed follows.
    void load(const Project& project, const Settings& settings);
    bool isBusy() const { return task_.isBusy(); }
    /// Nothing more is heard of what is being read but `cancelled`.
    void cancel();

  signals:
    /// "Reading ship.flt, 2.4 s", again and again; empty when there is nothing to wait for any
    /// more. What is read within a moment is not told of.
    void waiting(const QString& words);
    void loaded(std::shared_ptr<smat::gui::DisplayScene> scene);
    void failed(const QStringList& sentences);
    /// With the names of the files.
    void cancelled(const QString& names);

  private:
    void tell();

    std::shared_ptr<ModelStore> models_;
    LatestTask task_;
    QTimer tick_;
    QElapsedTimer clock_;
    QString names_;
};

} // namespace smat::gui
