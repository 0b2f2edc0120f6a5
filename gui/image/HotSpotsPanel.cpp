#include "gui/image/HotSpotsPanel.h"

#include <QVBoxLayout>

#include "gui/image/FiguresTable.h"
#include "gui/image/ImageExport.h"
#include "gui/image/IndexColors.h"
#include "gui/widgets/NumberFormat.h"

namespace smat::gui {

HotSpotsPanel::HotSpotsPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("hotSpotsPanel");
    table_ = new FiguresTable(this);
    table_->setObjectName("hotSpots");
    table_->setToolTip(tr("Choose a spot to see it in the middle of the image"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 4, 0, 0);
    column->addWidget(table_);
    setMinimumHeight(150);
    connect(table_, &QTableWidget::cellClicked, this, [this](int row) {
        if (row >= 0 && static_cast<std::size_t>(row) < spots_.size()) {
            const irsg::HotSpot& spot = spots_[static_cast<std::size_t>(row)];
            emit chosen({spot.x, spot.y});
        }
    });
}

void HotSpotsPanel::clear() {
    spots_.clear();
    table_->setFigures({}, {});
}

void HotSpotsPanel::show(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                         const std::vector<irsg::HotSpot>& spots) {
    spots_ = spots;
    QStringList headings{tr("Spot"), titleWithUnit(plane), tr("x"), tr("y")};
    for (const irsg::ImageChannel& channel : image.channels)
        if (&channel != &plane)
            headings << titleWithUnit(channel);
    QList<QStringList> rows;
    for (const irsg::HotSpot& spot : spots) {
        QStringList row{QString::number(rows.size() + 1), formattedNumber(spot.value),
                        QString::number(spot.x), QString::number(spot.y)};
        for (const irsg::ImageChannel& channel : image.channels)
            if (&channel != &plane)
                row << valueWords(image, channel, image.offset(spot.x, spot.y));
        rows << row;
    }
    table_->setFigures(headings, rows);
}

} // namespace smat::gui

#include "moc_HotSpotsPanel.cpp"
