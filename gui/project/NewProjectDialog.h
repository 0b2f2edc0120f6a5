#pragma once

#include <optional>

#include <QDialog>

#include "gui/widgets/Dialogs.h"
#include "smatcore/project/Project.h"

class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace smat::gui {

class PlacingFields;

/// Begins a project from a model, its signature database, a title and the placing of
/// the model.
class NewProjectDialog : public QDialog {
    Q_OBJECT

  public:
    explicit NewProjectDialog(Dialogs& dialogs, QWidget* parent = nullptr);
    /// Without a file of its own yet.
    Project project() const;
    /// Of the model as it is placed, in m; none while it is being read.
    std::optional<irsg::BoundingBox> bounds() const;
    bool isAcceptable() const;

  private:
    QLineEdit* addFile(QFormLayout* form, const QString& name, const QString& label,
                       const QString& title, const QStringList& filters);
    void onModelChanged();
    void refresh();

    Dialogs& dialogs_;
    QLineEdit* model_ = nullptr;
    QLineEdit* database_ = nullptr;
    QLineEdit* title_ = nullptr;
    PlacingFields* placing_ = nullptr;
    QLabel* remark_ = nullptr;
    QPushButton* create_ = nullptr;
};

} // namespace smat::gui
