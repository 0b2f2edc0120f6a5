#pragma once

#include <QWidget>

#include "gui/plot/PlotData.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"
#include "smatcore/tools/GasOutput.h"

class QCheckBox;
class QComboBox;

namespace smat::gui {

class PlotPanel;

/// The spectrum of layers of gas: radiance with its stated error, beside it what each gas adds,
/// RADCAL and the product of means, where they are chosen; or transmittances.
class GasPlot : public QWidget, public Exportable {
    Q_OBJECT

  public:
    explicit GasPlot(Dialogs dialogs, QWidget* parent = nullptr);

    void setOutput(GasOutput output);
    const PlotPanel& plot() const { return *panel_; }

    QStringList exportFilters() const override;
    /// A picture, or the curves that are seen as .csv. Throws irsg::InputError.
    void exportTo(const std::filesystem::path& file) const override;

  private:
    QCheckBox* makeChoice(const char* name, const QString& text, const QString& tip);
    void draw();
    void addRadiances(PlotData& data) const;
    void addTransmittances(PlotData& data) const;
    /// A column of the table over the wavelength, behind that of all, which is drawn last.
    void addCurve(PlotData& data, const QString& name, const std::vector<double>& values) const;

    GasOutput output_;
    PlotPanel* panel_ = nullptr;
    QComboBox* quantity_ = nullptr;
    QCheckBox *parts_ = nullptr, *radcal_ = nullptr, *product_ = nullptr;
};

} // namespace smat::gui
