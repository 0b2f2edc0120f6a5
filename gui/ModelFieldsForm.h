#pragma once

#include <map>
#include <optional>
#include <string>

#include <QWidget>

#include "smatcore/project/ModelFields.h"

class QGridLayout;
class QLineEdit;

namespace smat::gui {

class Workbench;

/// Place and state of a model that is not the target, a field for each number, in force as it is
/// typed; steps that can be undone.
class ModelFieldsForm : public QWidget {
    Q_OBJECT

  public:
    explicit ModelFieldsForm(Workbench& workbench, QWidget* parent = nullptr);

    /// Of the chosen model of the project.
    void refresh();

  private:
    void addRow(QGridLayout* grid, const ModelField& field);
    void onText(const ModelField& field);
    void finish(const ModelField& field);
    std::string valueOf(const ModelField& field) const;
    QString typedIn(const ModelField& field) const;

    Workbench& workbench_;
    std::map<std::string, QLineEdit*> fields_;
    std::size_t shown_ = 0;             ///< the model that the fields are of
    std::optional<std::string> before_; ///< the typing that goes on
};

} // namespace smat::gui
