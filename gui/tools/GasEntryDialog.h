#pragma once

#include <memory>

#include <QDialog>

#include "irsg/signature/SignatureDatabase.h"
#include "smatcore/tools/GasEntries.h"

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace smat::gui {

/// Asks as what a gas goes to a signature database, and under which name and indices; free ones are
/// offered.
class GasEntryDialog : public QDialog {
    Q_OBJECT

  public:
    enum class What {
        zone,          ///< the chosen layer, filling closed meshes
        layerSpectrum, ///< the chosen layer as a surface that emits its spectrum
        allSpectrum    ///< all layers as one
    };

    /// `layers`: how many there are; `chosen` counts from 0. `name` is offered.
    GasEntryDialog(std::shared_ptr<const irsg::SignatureDatabase> database, std::size_t layers,
                   std::size_t chosen, const QString& name, QWidget* parent = nullptr);

    What what() const;
    /// As it is typed; sound once the dialog was accepted.
    const GasEntryPlace& place() const { return place_; }

  private:
    void refresh();
    QString problem();

    std::shared_ptr<const irsg::SignatureDatabase> database_;
    GasEntryPlace place_;
    QComboBox* what_ = nullptr;
    QLineEdit *name_ = nullptr, *material_ = nullptr, *temperature_ = nullptr;
    QLabel* outcome_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

} // namespace smat::gui
