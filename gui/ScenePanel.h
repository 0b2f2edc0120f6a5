#pragma once

#include <QDockWidget>

#include "gui/settings/SettingForm.h"

class QLabel;

namespace smat::gui {

class Workbench;

/// The project that is open, and its camera, target and state to edit: the numbers behind the 3-D
/// view, in step with it.
class ScenePanel : public QDockWidget {
    Q_OBJECT

  public:
    ScenePanel(Workbench& workbench, FileChooser chooseFile, QWidget* parent = nullptr);

  private:
    void refresh();

    Workbench& workbench_;
    QLabel* title_ = nullptr;
    QLabel* models_ = nullptr;
    SettingForm* form_ = nullptr;
};

} // namespace smat::gui
