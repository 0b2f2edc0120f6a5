#pragma once

#include <filesystem>
#include <vector>

#include <QStringList>
#include <QWidget>

#include "gui/Exportable.h"
#include "gui/Workbench.h"

class QComboBox;

namespace smat::gui {

class CartesianPlot;
class ImageView;
class PolarPlot;

/// A tab with one result, or several on one plot: an image, a polar plot or a Cartesian one, with
/// what belongs to it.
class ResultPage : public QWidget, public Exportable {
    Q_OBJECT

  public:
    /// LogicError for no result; irsg::InputError for results that do not go on one plot.
    explicit ResultPage(const std::vector<ResultEntry>& results, QWidget* parent = nullptr);

    const QList<int>& resultIds() const { return ids_; }
    ImageView* imageView() const { return image_; }
    PolarPlot* polarPlot() const { return polar_; }
    CartesianPlot* cartesianPlot() const { return cartesian_; }

    /// Filters of a file dialog for what this page can be written as, data first.
    QStringList exportFilters() const override;
    /// By the suffix of the file. Throws irsg::InputError.
    void exportTo(const std::filesystem::path& file) const override;

  private:
    void showImage();
    void showPlot();
    void drawQuantity();
    void makeBar(QWidget* plot);

    std::vector<ResultEntry> results_;
    QList<int> ids_;
    ImageView* image_ = nullptr;
    PolarPlot* polar_ = nullptr;
    CartesianPlot* cartesian_ = nullptr;
    QComboBox* quantity_ = nullptr;
};

} // namespace smat::gui
