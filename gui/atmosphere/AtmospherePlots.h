#pragma once

#include <QWidget>

#include "gui/atmosphere/AtmospherePreview.h"

class QBoxLayout;
class QLabel;

namespace smat::gui {

class CartesianPlot;

/// What an air does: transmittance and path radiance along a line of sight over the wavelength, and
/// beside or below them temperature and humidity over the altitude.
class AtmospherePlots : public QWidget {
    Q_OBJECT

  public:
    explicit AtmospherePlots(QWidget* parent = nullptr);

    void showSpectra(const AtmosphereSpectra& spectra);
    void showColumn(const AtmosphereProfile& column);
    /// Nothing to show, and why.
    void clear();
    const AtmosphereSpectra& spectra() const { return spectra_; }
    const AtmosphereProfile& column() const { return column_; }

  protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    CartesianPlot* addPlot(QBoxLayout& layout, const char* name);

    AtmosphereSpectra spectra_;
    AtmosphereProfile column_;
    QBoxLayout *all_ = nullptr, *profiles_ = nullptr;
    CartesianPlot *transmittance_ = nullptr, *radiance_ = nullptr, *temperature_ = nullptr,
                  *humidity_ = nullptr;
};

} // namespace smat::gui
