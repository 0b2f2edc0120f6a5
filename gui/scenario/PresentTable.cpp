#include "gui/scenario/PresentTable.h"

#include <QHeaderView>

#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberFormat.h"

namespace smat::gui {

PresentTable::PresentTable(QWidget* parent) : QTableWidget(parent) {
    setObjectName("entitiesNow");
    const QStringList titles{
        tr("Entity"), tr("Range\n(m)"), tr("Intensity"), tr("Contrast intensity"),
        tr("Pixels"), tr("Power"),      tr("Mach"),      tr("Altitude\n(m)")};
    setColumnCount(static_cast<int>(titles.size()));
    setHorizontalHeaderLabels(titles);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setAlternatingRowColors(true);
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setTabKeyNavigation(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setStretchLastSection(true);
    setMinimumHeight(90);
}

void PresentTable::showMoment(const Scenario& scenario, const ScenarioPicture& picture) {
    setRowCount(static_cast<int>(scenario.entities.size()));
    for (std::size_t i = 0; i < scenario.entities.size(); ++i) {
        const int row = static_cast<int>(i);
        int column = 0;
        const auto put = [&](const QString& text) {
            auto* cell = item(row, column);
            if (cell == nullptr) {
                cell = new QTableWidgetItem;
                cell->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) |
                                       Qt::AlignVCenter);
                setItem(row, column, cell);
            }
            cell->setText(text);
            ++column;
        };
        put(textOf(scenario.entities[i].name));
        const auto& at = i < picture.entities.size() ? picture.entities[i] : std::nullopt;
        const auto object = i < picture.objects.size() ? picture.objects[i]
                                                       : std::optional<irsg::ObjectRadiometry>();
        const auto number = [](bool isThere, double value) {
            return isThere ? formattedNumber(value) : QStringLiteral("–");
        };
        const auto intensity = [](bool isThere, double value) {
            return isThere ? valueWithUnit(value, "W sr-1") : QStringLiteral("–");
        };
        const irsg::ObjectRadiometry seen = object.value_or(irsg::ObjectRadiometry{});
        const TrajectoryPoint point = at.value_or(TrajectoryPoint{});
        put(!at ? tr("not there") : number(object.has_value(), seen.range_m));
        put(intensity(object.has_value(), seen.intensity_W_sr));
        put(intensity(object.has_value(), seen.contrastIntensity_W_sr));
        put(number(object.has_value(), seen.coveredPixels));
        put(number(at.has_value(), point.power));
        put(number(at.has_value(), point.mach));
        put(number(at.has_value(), point.pose.position_m.z));
    }
}

} // namespace smat::gui

#include "moc_PresentTable.cpp"
