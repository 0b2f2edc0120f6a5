#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <QString>
#include <QWidget>

#include "smatcore/settings/Settings.h"

class QFormLayout;

namespace smat::gui {

/// Asks for a file; empty when nothing was chosen.
using FileChooser = std::function<QString(const QString& title, const QString& filter)>;

/// A form made from the descriptions of settings: label, unit, range, choices, and the
/// documentation as tooltip. A text that is no value is marked and keeps isValid() false.
class SettingForm : public QWidget {
    Q_OBJECT

  public:
    /// Shows the settings with these keys, in this order. Each field is named by its key.
    /// `withHelp` writes help and range below each field instead of into its tooltip alone.
    SettingForm(const std::vector<std::string>& keys, FileChooser chooseFile,
                QWidget* parent = nullptr, bool withHelp = false);

    void setValues(const Settings& settings);
    void setValue(const std::string& key, const std::string& text);
    /// The canonical text of a field; empty where it is no value.
    std::string value(const std::string& key) const;
    bool isValid() const;
    /// What is edited is in force at once: a text that is no value gives way to the value before
    /// its typing when the typing is over, with a sentence.
    void setLive() { isLive_ = true; }
    /// "Width: a number from 1 to 16384 (px)" for each field that is no value.
    QStringList problems() const;
    /// Puts the fields into settings, those that differ from what is there.
    void writeTo(Settings& settings) const;
    /// Hides the settings for experts, except those that are not at their default and those in
    /// `always`.
    void setExpertVisible(bool visible, const std::vector<std::string>& always = {});
    /// These take no part in what the form is for: faint, with the reason in their tooltip.
    void setUnused(const std::vector<std::string>& keys);
    /// Shows the settings alone whose label, key, option or help has all these words, those for
    /// experts, too. How many there are.
    int showMatching(const QStringList& words);
    const std::vector<std::string>& keys() const { return keys_; }
    /// Help, range and key of a setting, for a tooltip or a panel.
    static QString helpText(const SettingInfo& info);

  signals:
    /// By the user, with a value that is right.
    void edited(const std::string& key);
    void validityChanged();

  private:
    struct Field {
        std::function<QString()> read;
        std::function<void(const QString&)> write;
        QWidget* widget = nullptr;
        bool valid = true;
        std::string before = {}; ///< the value that was set last
    };
    QWidget* makeField(const SettingInfo& info);
    QWidget* makeText(const SettingInfo& info, bool isFile);
    QWidget* makeChoice(const SettingInfo& info, bool editable);
    QWidget* makeNamed(const SettingInfo& info);
    QWidget* makeCheck(const SettingInfo& info);
    void onEdited(const std::string& key);
    void finish(const std::string& key);
    bool mark(const std::string& key);

    FileChooser chooseFile_;
    std::vector<std::string> keys_;
    QFormLayout* layout_ = nullptr;
    bool isLive_ = false;
    std::map<std::string, Field> fields_;
};

/// Keys of a section of the table in its order; expert ones only when asked.
std::vector<std::string> settingKeys(const std::string& section, bool withExpert = true);

} // namespace smat::gui
