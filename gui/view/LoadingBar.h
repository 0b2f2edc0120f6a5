#pragma once

#include <QWidget>

namespace smat::gui {

class SceneLoader;

/// In the status bar, while models of the view are read: which, for how long, and a cancel. Hidden
/// else.
class LoadingBar : public QWidget {
    Q_OBJECT

  public:
    explicit LoadingBar(SceneLoader& loader, QWidget* parent = nullptr);
};

} // namespace smat::gui
