#pragma once

#include <memory>

#include <QWidget>

#include "gui/scenario/ScenarioPictures.h"
#include "gui/scenario/SimulationFrames.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"
#include "gui/workbench/DocumentPage.h"

class QComboBox;
class QLabel;
class QSplitter;
class QTabWidget;
class QToolButton;

namespace smat::gui {

class FlowBar;
class FramesPanel;
class ImageView;
class PlanView;
class PresentTable;
class TimeLine;
class Workbench;

/// A scenario: what one of its sensors sees at a time, a line of time to play it, where everybody
/// is, and the fields in which it is edited.
class ScenarioPage : public QWidget, public Exportable, public DocumentPage {
    Q_OBJECT

  public:
    ScenarioPage(std::unique_ptr<ScenarioDocument> document, Workbench& workbench, Dialogs dialogs,
                 QWidget* parent = nullptr);
    ~ScenarioPage() override;

    ScenarioDocument& document() { return *document_; }
    TimeLine& timeLine() { return *timeLine_; }
    ImageView& imageView() { return *image_; }
    /// The last one that was drawn.
    const ScenarioPicture& picture() const { return picture_; }
    bool isBusy() const { return pictures_->isBusy(); }
    std::size_t shownSensor() const;
    void showSensor(std::size_t sensor);
    /// "flyby.json", with a mark where it has unsaved edits.
    QString title() const;

    QString noun() const override { return tr("scenario"); }
    bool save() override;
    bool saveAs() override;
    bool mayClose() override;
    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  signals:
    void titleChanged(const QString& title);
    void said(const QString& sentence);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void makeParts();
    FlowBar* makeBar();
    void connectParts();
    void followDocument();
    void ask();
    void show(const ScenarioPicture& picture);
    void useDisplay(const Settings& settings);
    void refreshBands(const ScenarioPicture& picture);
    void tellProblems(const QStringList& sentences);
    /// Asks what is to be written and puts it in the line of jobs.
    void run();
    void connectJobs();
    void takeFilm(const FilmOutcome& film);
    void takeOutcome(const std::shared_ptr<const SimulationFrames>& outcome);
    bool saveTo(std::filesystem::path file);

    std::unique_ptr<ScenarioDocument> document_;
    Workbench& workbench_;
    Dialogs dialogs_;
    ScenarioPictures* pictures_ = nullptr;
    ScenarioPicture picture_;
    std::optional<std::size_t> displayedSensor_; ///< whose colours the view has
    QSplitter* parts_ = nullptr;
    QSplitter* halves_ = nullptr;
    ImageView* image_ = nullptr;
    QLabel* notice_ = nullptr;
    TimeLine* timeLine_ = nullptr;
    QTabWidget* panels_ = nullptr;
    PresentTable* present_ = nullptr;
    PlanView* plan_ = nullptr;
    QComboBox* sensor_ = nullptr;
    QComboBox* band_ = nullptr;
    QLabel* notes_ = nullptr;
    QToolButton* run_ = nullptr;
    FramesPanel* frames_ = nullptr;
    int job_ = 0, film_ = 0;  ///< of this page, as they run or wait
    bool toldOfFilm_ = false; ///< what became of it
};

} // namespace smat::gui
