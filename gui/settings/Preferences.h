#pragma once

#include <string>

#include <QDialog>
#include <QStringList>

#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/Theme.h"

class QComboBox;
class QSpinBox;

namespace smat::gui {

/// What belongs to the person in front of the window and not to a project. Kept in one readable
/// file, preferences.ini in the user's folder of settings.
struct Preferences {
    ThemeMode theme = ThemeMode::system;
    std::string colorMap = "white-hot"; ///< of projects that are begun, a name of irsg::ColorMap
    int recoveryDelay_s = 5;            ///< from an edit to the recovery copy, 1 to 600
    DisplayUnits units = {};

    bool operator==(const Preferences&) const = default;

    static QString file();
    /// Defaults where there is no file. A value that is none is named in `problems` and its default
    /// stands in.
    static Preferences load(QStringList* problems = nullptr);
    /// Throws irsg::InputError where the file cannot be written.
    void save() const;
};

/// Theme, colour map, recovery copies and units.
class PreferencesDialog : public QDialog {
    Q_OBJECT

  public:
    explicit PreferencesDialog(const Preferences& preferences, QWidget* parent = nullptr);
    Preferences preferences() const;

  private:
    QComboBox* theme_ = nullptr;
    QComboBox* colorMap_ = nullptr;
    QSpinBox* delay_ = nullptr;
    QComboBox* spectral_ = nullptr;
    QComboBox* intensity_ = nullptr;
    QComboBox* temperature_ = nullptr;
};

} // namespace smat::gui
