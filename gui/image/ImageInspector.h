#pragma once

#include <memory>
#include <optional>

#include <QWidget>

#include "gui/widgets/LatestTask.h"
#include "irsg/image/Histogram.h"
#include "irsg/image/ImageStatistics.h"
#include "irsg/image/RadianceImage.h"

class QBoxLayout;
class QCheckBox;
class QLabel;

namespace smat::gui {

class FiguresTable;
class HistogramPlot;

/// What is known of a plane, or of a rectangle of it.
struct PlaneFigures {
    irsg::ImageStatistics statistics;
    std::optional<double> contrastIntensity_W_sr;
};
PlaneFigures figuresOf(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                       const std::optional<irsg::PixelRectangle>& rectangle);

/// Histogram and statistics of a plane and of its rectangle, worked out off the window's thread.
class ImageInspector : public QWidget {
    Q_OBJECT

  public:
    explicit ImageInspector(QWidget* parent = nullptr);

    /// `plane` belongs to `image`; `title` is its quantity with unit.
    void show(std::shared_ptr<const irsg::RadianceImage> image, const irsg::ImageChannel& plane,
              const QString& title, const QString& unit);
    /// The histogram is that of the rectangle while there is one.
    void setRectangle(const std::optional<irsg::PixelRectangle>& rectangle);
    void setLimits(const irsg::DisplayLimits& limits);
    /// Without anything to show.
    void clear();
    /// The table beside the histogram, or below it.
    void setTableBelow(bool below);
    HistogramPlot* histogram() const { return histogram_; }
    FiguresTable* table() const { return table_; }
    bool isBusy() const { return task_.isBusy(); }

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    struct Answer {
        PlaneFigures image;
        std::optional<PlaneFigures> rectangle;
        irsg::Histogram histogram;
    };
    void refresh();
    void fill(const Answer& answer);

    std::shared_ptr<const irsg::RadianceImage> image_;
    const irsg::ImageChannel* plane_ = nullptr;
    QString title_, unit_;
    std::optional<irsg::PixelRectangle> rectangle_;
    std::optional<PlaneFigures> ofImage_; ///< those of the plane, once they are known
    HistogramPlot* histogram_ = nullptr;
    FiguresTable* table_ = nullptr;
    QCheckBox* logarithmicCounts_ = nullptr;
    QCheckBox* logarithmicValues_ = nullptr;
    QLabel* scope_ = nullptr;
    QBoxLayout* row_ = nullptr;
    bool stale_ = false;
    LatestTask task_;
};

} // namespace smat::gui
