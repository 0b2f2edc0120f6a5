#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QDockWidget>

class QComboBox;
class QGridLayout;
class QLineEdit;
class QSlider;

namespace smat::gui {

class ModelFieldsForm;
class SettingForm;
class Workbench;

/// Camera azimuth, elevation and range and the target's yaw, pitch and roll, each with a slider and
/// a text field that takes any number, and below them altitude and state; of another model that is
/// chosen its place and state. In step with the 3-D view; a drag is one step to undo.
class ManipulatorsDock : public QDockWidget {
    Q_OBJECT

  public:
    explicit ManipulatorsDock(Workbench& workbench, QWidget* parent = nullptr);

  private:
    /// The numbers a slider reaches; a field takes all that its setting allows.
    struct Reach {
        double minimum = 0.0, maximum = 0.0;
        bool isLogarithmic = false;
    };
    struct Row {
        Reach reach;
        QSlider* slider = nullptr;
        QLineEdit* field = nullptr;
        std::optional<std::string> before = {}; ///< the typing that goes on
    };
    void addRow(QGridLayout* grid, const std::string& key, const QString& label,
                const Reach& reach);
    void addViews(QGridLayout* grid);
    void onSlider(const std::string& key, int position);
    void onText(const std::string& key);
    void finish(const std::string& key);
    void refresh();
    void refreshModels();
    static int positionOf(const Reach& reach, double value);
    static double valueAt(const Reach& reach, int position);

    Workbench& workbench_;
    std::map<std::string, Row> rows_;
    std::vector<QWidget*> ofTarget_; ///< rows of the target alone
    QComboBox* models_ = nullptr;
    ModelFieldsForm* others_ = nullptr;
    SettingForm* form_ = nullptr;
    bool refreshing_ = false;
};

} // namespace smat::gui
