#pragma once

#include <functional>
#include <string>

#include "gui/tools/AtmosphereToolPage.h"
#include "gui/widgets/LatestTask.h"
#include "smatcore/tools/GasEntries.h"
#include "smatcore/tools/GasInput.h"

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace smat::gui {

class GasLayersBox;
class GasPlot;
class NumberField;

/// Hot gas: spectrum and band radiance of layers of combustion products, by themselves or through
/// an atmosphere, as the command `gas` computes them. A layer, or the spectrum of layers, can be
/// added to the signature database that is open.
class GasPage : public AtmosphereToolPage {
    Q_OBJECT

  public:
    GasPage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    /// As the fields have it; of texts that cannot stand the value before.
    GasInput input() const;
    GasLayersBox& layers() const { return *layers_; }
    const GasPlot& plot() const { return *plot_; }
    bool isAdding() const { return adding_.isBusy(); }

  protected:
    Calculation::Work work() override;
    QString refusalTitle() const override { return tr("This gas cannot be computed"); }

  private:
    void makeForm();
    /// `name`: that of its diagnostics; `put` puts a number into an input.
    NumberField* makeNumber(const std::string& name, const QString& unit, double value, double step,
                            const QString& tip, const std::function<void(GasInput&, double)>& put);
    /// In front of a number that need not be given.
    QCheckBox* makeGiven(const char* object, const std::string& name, NumberField& field);
    void takeFromProject();
    void chooseAtmosphere(int index);
    std::vector<std::filesystem::path> chosenAtmosphere() const;
    void readBand();
    void refresh();
    QStringList problems() const;
    void showOutput(const GasOutput& output);
    void addToDatabase();
    void addSurface(const irsg::GasRequest& request, const GasEntryPlace& place);
    void edit(const GasEntryPlace& place,
              const std::function<void(irsg::SignatureDatabase&)>& change);

    GasLayersBox* layers_ = nullptr;
    QLineEdit* band_ = nullptr;
    QComboBox *source_ = nullptr, *atmosphere_ = nullptr;
    NumberField *step_ = nullptr, *background_ = nullptr;
    NumberField *altitude_ = nullptr, *range_ = nullptr, *sensorAltitude_ = nullptr;
    QCheckBox *hasBackground_ = nullptr, *hasSensorAltitude_ = nullptr;
    QPushButton *take_ = nullptr, *add_ = nullptr;
    GasPlot* plot_ = nullptr;
    int chosenAtmosphere_ = 0;      ///< of the list
    irsg::SpectralRange rightBand_; ///< the last that its field said
    QString bandProblem_;           ///< of the text in the field; empty for none
    LatestTask adding_;             ///< last: nothing of it is heard once the rest goes
};

} // namespace smat::gui
