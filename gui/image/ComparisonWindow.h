#pragma once

#include <array>
#include <memory>
#include <optional>

#include <QWidget>

#include "gui/Dialogs.h"
#include "gui/Exportable.h"
#include "gui/LatestTask.h"
#include "irsg/image/ImageComparison.h"
#include "irsg/image/PngView.h"
#include "irsg/image/RadianceImage.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QTabWidget;
class QToolButton;

namespace smat::gui {

class ComparisonPanes;
class FiguresTable;
class ImageInspector;
class ThresholdForm;

/// One of two images that are compared.
struct ComparisonSide {
    std::shared_ptr<const irsg::RadianceImage> image; ///< null: none yet
    QString name;                                     ///< of its file, or of its result
    QString file; ///< that holds the image; empty for a result that is not saved

    /// Of a file.
    static ComparisonSide of(irsg::RadianceImage image, const QString& file) {
        return {std::make_shared<const irsg::RadianceImage>(std::move(image)), file, file};
    }
};

/// Two images and their difference with all that is to be said of it: see ComparisonPanes for the
/// views, irsg::ImageComparison for the numbers. Files are opened with the buttons or dropped, one
/// on A or B, or two at once. Images that do not go together are shown, and why they cannot be
/// compared is said. Everything has a key, see comparisonKeys().
class ComparisonWindow : public QWidget, public Exportable {
    Q_OBJECT

  public:
    explicit ComparisonWindow(QWidget* parent = nullptr, Dialogs dialogs = Dialogs::ofDesktop());
    ComparisonWindow(ComparisonSide a, ComparisonSide b, QWidget* parent = nullptr,
                     Dialogs dialogs = Dialogs::ofDesktop());
    ~ComparisonWindow() override;

    void setSides(ComparisonSide a, ComparisonSide b);
    const ComparisonSide& side(int index) const { return sides_[static_cast<std::size_t>(index)]; }
    /// Reads one or two files off the window's thread. What cannot be read is told, one sentence a
    /// file, and what was there stays; where nothing was, the file that can be read is taken. One
    /// file becomes A, or B where A is there and B is not, or `side`.
    void openFiles(const QStringList& files, std::optional<int> side = {});
    void swapSides();

    void setDifferenceMode(irsg::DifferenceMode mode);
    irsg::DifferenceMode differenceMode() const { return mode_; }
    /// Options in effect: thresholds and channel, without the rectangle.
    const irsg::ComparisonOptions& options() const { return options_; }
    /// None where the images cannot be compared, and while the numbers are worked out.
    const std::optional<irsg::Comparison>& comparison() const { return whole_; }
    const std::optional<irsg::Comparison>& comparisonOfRectangle() const { return part_; }
    /// Why the images cannot be compared; empty where they can.
    QString refusal() const { return refusal_; }
    bool isBusy() const;

    ComparisonPanes* panes() const { return panes_; }
    ThresholdForm* thresholds() const { return thresholds_; }
    FiguresTable* numbers() const { return numbers_; }
    /// "x 3   y 4     A 1.2     B 1     A − B 0.2 W·m⁻²·sr⁻¹".
    QString readoutAt(int x, int y) const;
    void goToWorstPixel();
    /// The line of smat-batch that gives the same numbers; empty while there are not two images,
    /// and where one is a result that no file holds.
    QString commandLine() const;

    QStringList exportFilters() const override;
    /// The difference as it is shown: .exr with A, B and all numbers, .csv, .png with its bar.
    void exportTo(const std::filesystem::path& file) const override;
    void copyPicture() const;
    void copyCommand() const;

  signals:
    /// Other images: "a.exr | b.exr".
    void titleChanged(const QString& title);
    /// No file could be read and there is nothing to see; it was told.
    void nothingRead();

  protected:
    void focusInEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    /// Of files that were to be read: a side of each, empty where it cannot be, and why.
    struct Reading {
        std::vector<ComparisonSide> sides;
        QStringList wrong;
    };
    static Reading readingOf(const QStringList& files);
    void take(Reading reading, int first);

    struct Answer {
        irsg::Comparison whole;
        std::optional<irsg::Comparison> part;
        std::vector<std::uint8_t> marks;
    };
    static Answer work(const irsg::RadianceImage& a, const irsg::RadianceImage& b,
                       const irsg::ComparisonOptions& options,
                       const std::optional<irsg::PixelRectangle>& part);

    // ComparisonParts.cpp
    void build();
    QWidget* makeBar();
    QWidget* makePanel();
    QWidget* makeCommandPart();
    void connectParts();

    void onSidesChanged();
    void fillPlanes();
    QString planeChoice() const;
    const irsg::ImageChannel* planeOf(std::size_t index) const;
    void showPlanes();
    void showDifference();
    void useDifference(std::shared_ptr<const irsg::RadianceImage> difference);
    void compare();
    /// After another rectangle: what is known of the whole stays.
    void compareRectangle();

    // ComparisonReport.cpp
    void take(Answer answer);
    void use(std::optional<irsg::Comparison> whole, std::optional<irsg::Comparison> part);
    void showVerdict();
    /// Whether somebody has said what counts as a failure, or values are missing.
    bool isJudged() const;
    void showCommand();
    void showMarks();
    void showReadout(std::optional<QPoint> pixel);

    /// A difference as it is exported.
    QImage pictureOfDifference(const irsg::RadianceImage& difference) const;
    void askForFile(int side);
    void askAndExport(const QString& filter);

    Dialogs dialogs_;
    std::array<ComparisonSide, 2> sides_;
    irsg::ComparisonOptions options_;
    irsg::DifferenceMode mode_ = irsg::DifferenceMode::signedDifference;
    std::shared_ptr<const irsg::RadianceImage> difference_;
    std::optional<irsg::Comparison> whole_, part_;
    std::vector<std::uint8_t> marks_;
    QString refusal_;
    std::optional<QPoint> pixel_; ///< that is read

    ComparisonPanes* panes_ = nullptr;
    ThresholdForm* thresholds_ = nullptr;
    FiguresTable* numbers_ = nullptr;
    ImageInspector* inspector_ = nullptr;
    QTabWidget* tabs_ = nullptr;
    QComboBox* plane_ = nullptr;
    QComboBox* colors_ = nullptr;
    QComboBox* modeBox_ = nullptr;
    QCheckBox* mark_ = nullptr;
    QToolButton* worst_ = nullptr;
    QToolButton* swap_ = nullptr;
    QToolButton* copy_ = nullptr;
    QToolButton* export_ = nullptr;
    QLabel* verdict_ = nullptr;
    QLabel* sentence_ = nullptr;
    QLabel* readout_ = nullptr;
    QWidget* commandPart_ = nullptr; ///< below the thresholds
    QLabel* commandWords_ = nullptr;
    QLineEdit* command_ = nullptr;
    QToolButton* copyCommand_ = nullptr;
    QAction* copyCommandAction_ = nullptr;
    LatestTask readTask_, compareTask_, partTask_, differenceTask_;
};

/// Keys of the comparison and what they do, beside those of images.
QList<std::pair<QString, QString>> comparisonKeys();

} // namespace smat::gui
