#pragma once

#include <memory>

#include <QWidget>

#include "gui/scenario/SimulationFrames.h"
#include "gui/widgets/Dialogs.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QListWidget;
class QToolButton;

namespace smat::gui {

class PlotPanel;

/// What a run of a scenario wrote: the frames of one sensor as a film strip in one scale of
/// colours, and its table as curves over time.
class FramesPanel : public QWidget {
    Q_OBJECT

  public:
    explicit FramesPanel(Dialogs dialogs, QWidget* parent = nullptr);

    void setOutcome(std::shared_ptr<const SimulationFrames> outcome, const QString& colorMap);
    const SimulationFrames* outcome() const { return outcome_.get(); }
    /// Of the scenario.
    void showSensor(std::size_t sensor);
    /// What is to be said of the run.
    void say(const QString& sentence);
    /// Whether a film of this panel is in the line of jobs: no other one is begun.
    void setFilming(bool filming);

  signals:
    void frameChosen(std::size_t sensor, std::size_t band, std::size_t number);
    void filmAsked(const smat::gui::FilmOrder& order);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// The strip beside the plot where the panel is low, above it where it is high.
    void arrange(bool beside);
    void fillStrip();
    void drawTable();
    /// What a film can be, and of what it cannot be why.
    void fillFilmMenu();
    void exportFilm(const QString& extension, const QString& filter);
    const FilmStrip* shownFilm() const;
    const SensorResult* shownResult() const;

    std::shared_ptr<const SimulationFrames> outcome_;
    QString colorMap_;
    std::size_t sensor_ = 0;
    Dialogs dialogs_;
    bool filming_ = false;
    QToolButton* film_ = nullptr;
    QLabel* words_ = nullptr;
    QListWidget* strip_ = nullptr;
    QComboBox* quantity_ = nullptr;
    PlotPanel* plot_ = nullptr;
    QBoxLayout* parts_ = nullptr;
};

} // namespace smat::gui
