#pragma once

#include "gui/database/EntryNumbers.h"
#include "gui/database/EntryPanel.h"

class QTabWidget;

namespace smat::gui {

class AngleCurve;
class SpectralProperty;

/// One material: emissivity, transmissivity, N angle factor and notes.
class MaterialPanel : public EntryPanel {
    Q_OBJECT

  public:
    explicit MaterialPanel(EditorContext& context, QWidget* parent = nullptr);
    QTabWidget* tabs() const { return tabs_; }

  protected:
    void refresh() override;

  private:
    SpectralProperty* makeProperty(bool emissivity);
    QWidget* makeAngle();

    QTabWidget* tabs_ = nullptr;
    SpectralProperty *emissivity_ = nullptr, *transmissivity_ = nullptr;
    std::optional<EntryNumbers<irsg::Material>> numbers_;
    AngleCurve* curve_ = nullptr;
};

} // namespace smat::gui
