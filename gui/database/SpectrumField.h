#pragma once

#include <QWidget>

#include "gui/database/Nodes.h"
#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/EntryFields.h"

class QComboBox;
class QPushButton;

namespace smat::gui {

class NumberField;

/// The grey value that a spectrum becomes: its mean in a band, to four decimals.
irsg::Spectrum greyMeanOf(const irsg::Spectrum& spectrum, const irsg::SpectralRange& band);
/// The nodes that a grey value becomes: at both ends and in the middle of a band.
irsg::Spectrum evenNodesOf(const irsg::Spectrum& grey, const irsg::SpectralRange& band);

/// A spectrum of a material in one line of a form, as its table of fields has it: grey, a number,
/// or spectral, how far it reaches and a button that opens its nodes elsewhere.
class SpectrumField : public QWidget {
    Q_OBJECT

  public:
    using Row = irsg::EntryField<irsg::Material>;

    SpectrumField(const Row& row, QWidget* parent);
    /// `band`: where nodes begin when it becomes spectral, and what its mean is taken over.
    void show(const irsg::Spectrum& value, const irsg::SpectralRange& band);
    const Row& row() const { return row_; }
    /// What its nodes may be.
    NodeRules rules() const;
    bool isOpen() const;
    void setOpen(bool open);

  signals:
    /// By the user: `what` ends the name of the step, as with NodeEditor.
    void edited(const irsg::Spectrum& value, const QString& what);
    void gestureEnded();
    /// By the user: its nodes are to be seen, or not.
    void opened(bool open);

  private:
    void chooseForm(bool isGrey);

    const Row& row_;
    irsg::Spectrum value_;
    irsg::SpectralRange band_;
    QComboBox* form_ = nullptr;
    NumberField* grey_ = nullptr;
    QPushButton* nodes_ = nullptr;
};

} // namespace smat::gui
