#pragma once

#include <vector>

#include <QDialog>

#include "smatcore/project/Project.h"

class QCheckBox;
class QLineEdit;
class QPlainTextEdit;
class QSpinBox;
class QTabWidget;

namespace smat::gui {

class PlacingFields;

/// Title and notes of a project, and of each model its name, how it is placed, whether faces
/// show both sides, and the entries that stand in for codes without one.
class ProjectPropertiesDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ProjectPropertiesDialog(const Project& project, QWidget* parent = nullptr);
    /// The project with what was changed here.
    Project project() const;

  private:
    struct ModelFields {
        QLineEdit* name = nullptr;
        PlacingFields* placing = nullptr;
        QCheckBox* twoSided = nullptr;
        QCheckBox* cutTextureAlpha = nullptr;
        QSpinBox* fallbackTemperature = nullptr;
        QSpinBox* fallbackMaterial = nullptr;
    };
    void addModel(const ProjectModel& model, QTabWidget* tabs);

    Project project_;
    QLineEdit* title_ = nullptr;
    QPlainTextEdit* notes_ = nullptr;
    std::vector<ModelFields> models_;
};

} // namespace smat::gui
