#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <QDialog>

#include "gui/widgets/LatestTask.h"
#include "irsg/geometry/model/FirstSignature.h"
#include "smatcore/project/Project.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;
class QTabWidget;

namespace smat::gui {

class NumberField;
class PlacingFields;

/// Takes a model without codes to its first infrared picture: what each of its surfaces, by the
/// names in the file, is made of and how warm it is, and how the file is placed. Begins with what
/// names and shape suggest.
class FirstSignatureDialog : public QDialog {
    Q_OBJECT

  public:
    /// Of a model of a project, which has a file.
    FirstSignatureDialog(const Project& project, std::size_t number, QWidget* parent = nullptr);

    /// Whether names and shape are there to be chosen from.
    bool isReady() const { return isReady_; }
    /// Writes the codes beside the model and a new database beside them; painted faces stay. Gives
    /// the project with both. Throws irsg::InputError.
    Project write() const;
    /// Of the model as it is placed, in m; none until it is read.
    std::optional<irsg::BoundingBox> bounds() const;

  private:
    struct Row {
        QComboBox* material = nullptr;
        QComboBox* temperature = nullptr;
        NumberField* kelvin = nullptr;
    };
    void fill(const irsg::ModelNames& names);
    std::vector<irsg::FirstSurface> surfaces() const;
    std::filesystem::path newDatabase() const;

    Project project_;
    std::size_t number_; ///< of the model in the project
    std::filesystem::path model_;
    std::vector<irsg::FirstSurface> suggested_;
    std::vector<Row> rows_;
    bool isReady_ = false;
    QTabWidget* tabs_ = nullptr;
    QTableWidget* table_ = nullptr;
    PlacingFields* placing_ = nullptr;
    QLabel* said_ = nullptr;
    QPushButton* create_ = nullptr;
    LatestTask task_;
};

} // namespace smat::gui
