#pragma once

#include <vector>

#include "gui/tools/AtmosphereToolPage.h"
#include "irsg/atmosphere/Atmosphere.h"
#include "smatcore/settings/Settings.h"

class QCheckBox;

namespace smat::gui {

class SettingForm;
class TargetPoint;

/// Radiative output (F51): spectra of the project's air between viewer and target for a place of
/// the viewer, an altitude of the target and a distance. The answer can be made an input of the
/// project: an image in it is the image in the air itself.
class RadiativePage : public AtmosphereToolPage {
    Q_OBJECT

  public:
    RadiativePage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    /// Takes the place of camera and target, the band and the sun from the project.
    void takeFromProject();

  protected:
    Calculation::Work work() override;

  private:
    void refresh();
    Settings settings() const;
    std::vector<std::string> words() const;
    void useInProject();

    SettingForm* form_ = nullptr;
    std::vector<QCheckBox*> quantities_;
    TargetPoint* targetPoint_;
};

} // namespace smat::gui
