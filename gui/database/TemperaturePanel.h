#pragma once

#include "gui/database/EntryPanel.h"

class QComboBox;
class QTabWidget;
class QStackedWidget;

namespace smat::gui {

class FactorsPanel;
class NodePlot;
class TemperatureResult;
class TermsPanel;

/// One temperature: what it emits with (eq. 7 or a user-defined spectrum, eq. 6), what comes of it
/// in the state of the project, the terms, the factors and the notes.
class TemperaturePanel : public EntryPanel {
    Q_OBJECT

  public:
    explicit TemperaturePanel(EditorContext& context, QWidget* parent = nullptr);
    QTabWidget* tabs() const { return tabs_; }

  signals:
    void spectrumRequested(const QString& name);

  protected:
    void refresh() override;

  private:
    void chooseMode(int mode);
    void chooseSpectrum(const QString& name);
    QWidget* makeEmission();
    void showEmission(const irsg::TemperatureEntry& entry);

    QComboBox *mode_ = nullptr, *spectrum_ = nullptr;
    QTabWidget* tabs_ = nullptr;
    QStackedWidget* emission_ = nullptr;
    TemperatureResult* result_ = nullptr;
    NodePlot* emitted_ = nullptr;
    TermsPanel* terms_ = nullptr;
    FactorsPanel* factors_ = nullptr;
};

} // namespace smat::gui
