#pragma once

#include <filesystem>
#include <optional>

#include <QWidget>

#include "gui/widgets/Dialogs.h"
#include "irsg/sensor/SensorDescription.h"

class QComboBox;
class QLabel;

namespace smat::gui {

/// The list of the sensors that come with the program, and of a file, with what the chosen one is.
class SensorChooser : public QWidget {
    Q_OBJECT

  public:
    explicit SensorChooser(Dialogs dialogs, QWidget* parent = nullptr);

    /// None where the chosen file is no usable one; then there is a problem().
    const std::optional<irsg::SensorDescription>& sensor() const { return sensor_; }
    std::filesystem::path file() const;
    const QString& problem() const { return problem_; }
    /// Takes the sensor of a file into the list and chooses it; tells what is wrong with it.
    void open(const std::filesystem::path& file);

  signals:
    /// Another one was chosen.
    void changed();

  private:
    void choose(int index);
    void describe();

    Dialogs dialogs_;
    QComboBox* list_ = nullptr;
    QLabel* text_ = nullptr;
    int chosen_ = 0; ///< in the list
    std::optional<irsg::SensorDescription> sensor_;
    QString problem_;
};

} // namespace smat::gui
