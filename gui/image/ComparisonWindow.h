#pragma once

#include <optional>

#include <QWidget>

#include "gui/image/ComparedPair.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"

class QLabel;

namespace smat::gui {

class ComparisonBar;
class ComparisonFiles;
class ComparisonKeys;
class ComparisonPanes;
class ComparisonReport;
class FiguresTable;
class ThresholdForm;

/// Two images and their difference with all that is to be said of it: see ComparisonPanes for the
/// views, ComparisonReport for the words and numbers. Files are opened with the buttons or dropped,
/// one on A or B, or two at once. Images that do not go together are shown, and why they cannot be
/// compared is said. Everything has a key, see ComparisonKeys.
class ComparisonWindow : public QWidget, public Exportable {
    Q_OBJECT

  public:
    explicit ComparisonWindow(QWidget* parent = nullptr, Dialogs dialogs = Dialogs::ofDesktop());
    ComparisonWindow(ComparisonSide a, ComparisonSide b, QWidget* parent = nullptr,
                     Dialogs dialogs = Dialogs::ofDesktop());
    ~ComparisonWindow() override;

    void setSides(ComparisonSide a, ComparisonSide b);
    const ComparisonSide& side(int index) const {
        return pair_->side(static_cast<std::size_t>(index));
    }
    /// See ComparisonFiles.
    void openFiles(const QStringList& files, std::optional<int> side = {});
    void swapSides();

    void setDifferenceMode(irsg::DifferenceMode mode);
    irsg::DifferenceMode differenceMode() const { return pair_->mode(); }
    /// Options in effect: thresholds and channel, without the rectangle.
    const irsg::ComparisonOptions& options() const { return pair_->options(); }
    /// None where the images cannot be compared, and while the numbers are worked out.
    const std::optional<irsg::Comparison>& comparison() const { return pair_->whole(); }
    const std::optional<irsg::Comparison>& comparisonOfRectangle() const { return pair_->part(); }
    bool isBusy() const;

    ComparisonPanes* panes() const { return panes_; }
    ThresholdForm* thresholds() const;
    FiguresTable* numbers() const;
    /// "x 3   y 4     A 1.2     B 1     A − B 0.2 W·m⁻²·sr⁻¹".
    QString readoutAt(int x, int y) const { return pair_->readoutAt(x, y); }
    void goToWorstPixel();
    /// The line of smat-batch that gives the same numbers; empty while there are not two images,
    /// and where one is a result that no file holds.
    QString commandLine() const;

    QStringList exportFilters() const override;
    /// The difference as it is shown: .exr with A, B and all numbers, .csv, .png with its bar.
    void exportTo(const std::filesystem::path& file) const override;
    void copyPicture() const;

  signals:
    /// Other images: "a.exr | b.exr".
    void titleChanged(const QString& title);
    /// No file could be read and there is nothing to see; it was told.
    void nothingRead();

  protected:
    void focusInEvent(QFocusEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void build();
    void connectBar();
    void connectParts();
    void showPlanes();
    void showDifference();
    void showFigures();
    void showMarks();
    void showReadout(std::optional<QPoint> pixel);

    /// A difference as it is exported.
    QImage pictureOfDifference(const irsg::RadianceImage& difference) const;
    void askAndExport(const QString& filter);

    Dialogs dialogs_;
    ComparedPair* pair_ = nullptr;
    ComparisonPanes* panes_ = nullptr;
    ComparisonReport* report_ = nullptr;
    ComparisonBar* bar_ = nullptr;
    ComparisonFiles* files_ = nullptr;
    ComparisonKeys* keys_ = nullptr;
    QLabel* readout_ = nullptr;
    std::optional<QPoint> pixel_; ///< that is read
};

} // namespace smat::gui
