#pragma once

#include <optional>

#include "gui/tools/AtmosphereToolPage.h"
#include "smatcore/tools/TemperatureProfile.h"

class QLabel;
class QLineEdit;

namespace smat::gui {

/// Temperature of the project's air over altitude (F47), from a least to a largest altitude in
/// steps.
class TemperatureProfilePage : public AtmosphereToolPage {
    Q_OBJECT

  public:
    TemperatureProfilePage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

  protected:
    Calculation::Work work() override;

  private:
    void refresh();
    std::optional<TemperatureProfileRequest> request() const;

    QLabel* air_ = nullptr;
    QLineEdit* min_ = nullptr;
    QLineEdit* max_ = nullptr;
    QLineEdit* step_ = nullptr;
};

} // namespace smat::gui
