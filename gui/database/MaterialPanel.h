#pragma once

#include "gui/database/EntryNumbers.h"
#include "gui/database/EntryPanel.h"

class QTabWidget;

namespace smat::gui {

class AngleCurve;
class SpectralProperty;
class SurfacePage;

/// One material: emissivity, transmissivity, N angle factor, surface model, gas and notes.
class MaterialPanel : public EntryPanel {
    Q_OBJECT

  public:
    explicit MaterialPanel(EditorContext& context, QWidget* parent = nullptr);
    QTabWidget* tabs() const { return tabs_; }

  signals:
    /// Of what its surface is made of, from a file into this index.
    void importWanted(int index);

  protected:
    void refresh() override;

  private:
    SpectralProperty* makeProperty(bool emissivity);
    QWidget* makeAngle();
    QWidget* makeSurface();
    QWidget* makeGas();
    void setNumber(const irsg::EntryField<irsg::Material>& row, double value);

    QTabWidget* tabs_ = nullptr;
    SpectralProperty *emissivity_ = nullptr, *transmissivity_ = nullptr;
    std::optional<EntryNumbers<irsg::Material>> numbers_, gas_;
    AngleCurve* curve_ = nullptr;
    SurfacePage* surface_ = nullptr;
};

} // namespace smat::gui
