#pragma once

#include <vector>

#include <QPoint>
#include <QWidget>

#include "irsg/image/HotSpots.h"

namespace smat::gui {

class FiguresTable;

/// The hottest spots of a plane as a table, with what the other planes have there: temperatures,
/// indices, ranges. Ctrl+C copies it.
class HotSpotsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit HotSpotsPanel(QWidget* parent = nullptr);

    /// `plane` belongs to `image`.
    void show(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
              const std::vector<irsg::HotSpot>& spots);
    void clear();
    FiguresTable* table() const { return table_; }

  signals:
    /// A row of the table was chosen.
    void chosen(const QPoint& pixel);

  private:
    FiguresTable* table_ = nullptr;
    std::vector<irsg::HotSpot> spots_;
};

} // namespace smat::gui
