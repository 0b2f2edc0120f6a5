#pragma once

#include <map>
#include <vector>

#include <QDockWidget>

#include "gui/paint/IndexBox.h"
#include "irsg/geometry/reading/ModelCodes.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace smat::gui {

/// What a click in the view, or a box drawn in it, chooses.
enum class PickBy { face, part, material, angle, box };
/// What the view shows while a model is painted.
enum class CodesShown { none, temperature, material };

/// A row of the legend: an index that faces of the model carry.
struct CodeRow {
    int index = 0;
    QString name;
    QColor color;
    long faces = 0;
    double area_m2 = 0.0;
};

/// The fields of the painter of codes: how faces are chosen in the view, which indices they get,
/// and which there are. It tells what a person wants; FacePainter does it.
class PaintDock : public QDockWidget {
    Q_OBJECT

  public:
    explicit PaintDock(QWidget* parent = nullptr);

    void setModels(const QStringList& names, int model);
    int model() const;
    PickBy pickBy() const;
    double angle_rad() const;
    bool takesHidden() const;
    irsg::GivenCodes codes() const;
    IndexBox& temperature() { return *temperature_; }
    IndexBox& material() { return *material_; }

    /// How many faces are chosen, and their area; `problem` in place of both where nothing can be
    /// painted.
    void setChosen(std::size_t faces, double area_m2, const QString& problem = {});
    CodesShown shown() const;
    void setLegend(const std::vector<CodeRow>& rows);

  signals:
    void modelChosen(int model);
    void pickByChosen();
    void paintWanted();
    void eraseWanted();
    void clearWanted();
    void shownChosen();
    /// The faces of this index of what is shown.
    void indexWanted(int index);

  private:
    QWidget* makePicking();
    QWidget* makePainting();
    QWidget* makeLegend();
    void refresh();

    QWidget* modelRow_ = nullptr;
    QComboBox* model_ = nullptr;
    QComboBox* by_ = nullptr;
    QDoubleSpinBox* angle_ = nullptr;
    QCheckBox* hidden_ = nullptr;
    QLabel* hint_ = nullptr;
    QLabel* chosen_ = nullptr;
    QPushButton* clear_ = nullptr;
    IndexBox* temperature_ = nullptr;
    IndexBox* material_ = nullptr;
    QPushButton* paint_ = nullptr;
    QPushButton* erase_ = nullptr;
    QComboBox* shown_ = nullptr;
    QTreeWidget* legend_ = nullptr;
    std::size_t faces_ = 0;
};

} // namespace smat::gui
