#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "gui/database/EntryNumbers.h"
#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/SignatureDatabase.h"

class QComboBox;
class QLabel;

namespace smat::gui {

class AngleCurve;
class LitBallView;
class NodeEditor;
class ReflectanceEditor;
class SpectrumField;

/// How a material reflects over directions: its model with the numbers, the spectra and the table
/// that it takes, each to be edited, its reflectance over angle in a band and a ball of it. Where
/// something lacks for these, it says what.
class SurfacePage : public QWidget {
    Q_OBJECT

  public:
    explicit SurfacePage(QWidget* parent = nullptr);
    void show(const irsg::Material& material, const irsg::SpectralRange& band);

  signals:
    void modelChosen(const std::string& name);
    void numberEdited(const irsg::EntryField<irsg::Material>& row, double value);
    /// `what` ends the name of the step.
    void spectrumEdited(const irsg::EntryField<irsg::Material>& row, const irsg::Spectrum& value,
                        const QString& what);
    void tableEdited(const irsg::ReflectanceTable& table, const QString& what);
    void gestureEnded();
    /// Of n and k, diffuse reflectivity or a table, from a file.
    void importWanted();

  private:
    using Row = irsg::EntryField<irsg::Material>;
    struct SpectrumLine {
        QLabel* label;
        SpectrumField* field;
    };
    void showNodes();

    irsg::Material material_;
    irsg::SpectralRange band_;
    QComboBox* model_ = nullptr;
    std::optional<EntryNumbers<irsg::Material>> numbers_;
    std::vector<SpectrumLine> spectra_;
    NodeEditor* nodes_ = nullptr;
    const Row* nodesOf_ = nullptr; ///< the spectrum whose nodes are seen
    ReflectanceEditor* table_ = nullptr;
    AngleCurve* curve_ = nullptr;
    LitBallView* ball_ = nullptr;
};

} // namespace smat::gui
