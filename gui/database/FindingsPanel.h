#pragma once

#include <QWidget>

#include "gui/database/EditorContext.h"

class QLabel;
class QTimer;
class QTreeWidget;

namespace smat::gui {

class FindingsScope;

/// What the physics has to say about the database as it stands: place, value, reason, and a button
/// that repairs where there is one way to.
class FindingsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit FindingsPanel(EditorContext& context, QWidget* parent = nullptr);

    int errors() const { return errors_; }
    int warnings() const { return warnings_; }
    /// Looks now instead of a moment after the last edit.
    void look();

  signals:
    void countsChanged();
    /// A person wants to see the place.
    void placeRequested(const QString& place);

  private:
    EditorContext& context_;
    FindingsScope* scope_ = nullptr;
    QTimer* timer_ = nullptr;
    QLabel* summary_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QLabel* detail_ = nullptr;
    int errors_ = 0, warnings_ = 0;
};

} // namespace smat::gui
