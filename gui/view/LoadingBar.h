#pragma once

#include <QPointer>
#include <QWidget>

#include "gui/workbench/ModelWait.h"

class QLabel;

namespace smat::gui {

/// In the status bar, while models are read: which, for how long, and a cancel. Hidden else.
class LoadingBar : public QWidget {
    Q_OBJECT

  public:
    explicit LoadingBar(QWidget* parent = nullptr);

    /// Tells of this one, too.
    void follow(ModelWait& wait);

  private:
    QLabel* words_;
    QPointer<ModelWait> told_; ///< the one that it tells of
};

} // namespace smat::gui
