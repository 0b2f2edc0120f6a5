#pragma once

#include <optional>

#include <QWidget>

#include "gui/database/EntryNumbers.h"
#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/SignatureDatabase.h"

class QComboBox;
class QLabel;

namespace smat::gui {

class AngleCurve;
class LitBallView;

/// How a material reflects over directions: its model with the numbers that it takes, what there is
/// of spectra and tables, its reflectance over angle in a band and a ball of it.
class SurfacePage : public QWidget {
    Q_OBJECT

  public:
    explicit SurfacePage(QWidget* parent = nullptr);
    void show(const irsg::Material& material, const irsg::SpectralRange& band);

  signals:
    void modelChosen(const std::string& name);
    void numberEdited(const irsg::EntryField<irsg::Material>& row, double value);
    void gestureEnded();
    /// Of n and k, diffuse reflectivity or a table, from a file.
    void importWanted();

  private:
    QComboBox* model_ = nullptr;
    std::optional<EntryNumbers<irsg::Material>> numbers_;
    QLabel* spectra_ = nullptr;
    AngleCurve* curve_ = nullptr;
    LitBallView* ball_ = nullptr;
};

} // namespace smat::gui
