#pragma once

#include <QObject>

#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {

class DatabaseDock;
class SceneView;
class Workbench;

/// Ties the database editor to the 3-D view: edits show at once in its infrared display, a face
/// that is picked selects its indices, and an index that a person selects marks its faces until the
/// next edit, so that no mark hides what the edit does.
class DatabasePreview : public QObject {
    Q_OBJECT

  public:
    DatabasePreview(Workbench& workbench, DatabaseDock& dock, SceneView& view,
                    QObject* parent = nullptr);

  private:
    void followEdits();
    void markCurrent();

    Workbench& workbench_;
    DatabaseDock& dock_;
    SceneView& view_;
    SceneBuilder::DatabaseOverrides shown_; ///< that the view has in place of files
};

} // namespace smat::gui
