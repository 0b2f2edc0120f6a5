#pragma once

#include <QWidget>

#include "irsg/radiometry/Spectrum.h"

class QComboBox;
class QLabel;

namespace smat::gui {

class NodeEditor;
class NumberField;

/// Emissivity or transmissivity of a material: grey, a number, or spectral, a table beside its
/// plot. The other of the two and the reflectivity that both leave are drawn behind it; it cannot
/// grow beyond what the other leaves.
class SpectralProperty : public QWidget {
    Q_OBJECT

  public:
    enum class Which { emissivity, transmissivity };
    explicit SpectralProperty(Which which, QWidget* parent = nullptr);

    /// `other` is the property that shares the sum of 1 with this one; `band` is always seen.
    void setValue(const irsg::Spectrum& value, const irsg::Spectrum& other,
                  const irsg::SpectralRange& band);

  signals:
    /// By the user: `what` ends the name of the step, as with NodeEditor.
    void edited(const irsg::Spectrum& value, const QString& what);
    void gestureEnded();

  private:
    void chooseForm(int form);
    void drawBackdrop();

    Which which_;
    irsg::Spectrum value_, other_;
    irsg::SpectralRange band_;
    QComboBox* form_ = nullptr;
    NumberField* grey_ = nullptr;
    QLabel* remark_ = nullptr;
    NodeEditor* nodes_ = nullptr;
    bool ruled_ = false;
};

} // namespace smat::gui
