#include "gui/tools/DetectionCasesBox.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>

#include "gui/widgets/NumberBoxes.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

namespace {

/// Entries of the list: aspects, directions, one for each RangeAgainst, probability.
constexpr int firstComparison = 2;

std::vector<std::string> listOf(const QLineEdit& field) {
    std::vector<std::string> list;
    for (const QString& word : field.text().split(',', Qt::SkipEmptyParts))
        list.push_back(word.trimmed().toStdString());
    return list;
}

QLineEdit* lineOf(const char* name, const QString& example, QWidget* parent) {
    auto* line = new QLineEdit(parent);
    line->setObjectName(name);
    line->setPlaceholderText(example);
    return line;
}

const char* exampleOf(RangeAgainst against) {
    switch (against) {
    case RangeAgainst::wind:
        return "2, 5, 10, 20 (m/s)";
    case RangeAgainst::visibility:
        return "5000, 10000, 23000 (m)";
    case RangeAgainst::humidity:
        return "20, 50, 80 (%)";
    case RangeAgainst::hour:
        return "0, 6, 12, 18 (h)";
    case RangeAgainst::band:
        return "3.7-4.2, 4.4-4.8 (µm)";
    case RangeAgainst::paint:
        return "0.3, 0.9, or names of materials";
    }
    return "";
}

} // namespace

DetectionCasesBox::DetectionCasesBox(QWidget* parent) : QWidget(parent) {
    form_ = new QFormLayout(this);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form_->setVerticalSpacing(3);
    form_->setContentsMargins({});
    what_ = new QComboBox(this);
    what_->setObjectName("tableOf");
    what_->addItems({tr("ranges over aspect"), tr("ranges over azimuth and elevation"),
                     tr("ranges against wind"), tr("ranges against visibility"),
                     tr("ranges against humidity"), tr("ranges against the hour"),
                     tr("ranges against the band"), tr("ranges against paint"),
                     tr("probability over range")});
    what_->setToolTip(tr("Rows of the table and abscissa of the plot"));
    values_ = lineOf("values", {}, this);
    values_->setToolTip(tr(
        "Separated by commas. Each row has the mean, shortest and longest range of all aspects."));
    paint_ = lineOf("paint", tr("a material of the target"), this);
    paint_->setToolTip(tr("The material of the target that is replaced"));
    sunOf_ = lineOf("sunOf", tr("2025-06-21, 54.3, 10.1"), this);
    sunOf_->setToolTip(tr("Day, latitude and longitude that give the sun at these hours of local "
                          "solar time; if empty, the sun does not move"));
    ranges_ = lineOf("ranges", tr("1000, 2000, 4000 (m)"), this);
    draws_ = new RealBox("draws", {}, this);
    draws_->setDecimals(0);
    draws_->setRange(0.0, 1e6);
    draws_->setSpecialValueText(tr("none"));
    draws_->setToolTip(tr("Draws from the scaling files beside the models, over which the "
                          "probability is averaged as well"));
    form_->addRow(what_);
    form_->addRow(tr("Values"), values_);
    form_->addRow(tr("Paint"), paint_);
    form_->addRow(tr("Sun of"), sunOf_);
    form_->addRow(tr("Ranges"), ranges_);
    form_->addRow(tr("Draws"), draws_);
    connect(what_, &QComboBox::currentIndexChanged, this, [this] {
        showFields();
        emit changed();
    });
    for (QLineEdit* line : {values_, paint_, sunOf_, ranges_})
        connect(line, &QLineEdit::textChanged, this, &DetectionCasesBox::changed);
    connect(draws_, &QDoubleSpinBox::valueChanged, this, &DetectionCasesBox::changed);
    showFields();
}

bool DetectionCasesBox::seeksRange() const {
    return what_->currentIndex() < what_->count() - 1;
}

bool DetectionCasesBox::isByCase() const {
    return what_->currentIndex() < firstComparison;
}

RangeCases DetectionCasesBox::cases() const {
    return what_->currentIndex() == 1 ? RangeCases::directions : RangeCases::aspects;
}

void DetectionCasesBox::showFields() {
    const bool isComparison = seeksRange() && !isByCase();
    const auto against = static_cast<RangeAgainst>(what_->currentIndex() - firstComparison);
    form_->setRowVisible(values_, isComparison);
    form_->setRowVisible(paint_, isComparison && against == RangeAgainst::paint);
    form_->setRowVisible(sunOf_, isComparison && against == RangeAgainst::hour);
    form_->setRowVisible(ranges_, !seeksRange());
    form_->setRowVisible(draws_, !seeksRange());
    if (isComparison)
        values_->setPlaceholderText(tr(exampleOf(against)));
}

void DetectionCasesBox::fill(DetectionRequest& request) const {
    request.cases = cases();
    if (!seeksRange()) {
        for (const std::string& text : listOf(*ranges_)) {
            const auto range_m = irsg::parseNumber(text);
            if (!range_m || *range_m <= 0.0)
                throw irsg::InputError({"", tr("Ranges").toStdString(), text,
                                        "ranges above 0 m, separated by commas"});
            request.ranges_m.push_back(*range_m);
        }
        if (request.ranges_m.empty())
            throw irsg::InputError({"", tr("Ranges").toStdString(), "nothing",
                                    "ranges above 0 m, separated by commas"});
        request.draws = static_cast<std::size_t>(draws_->value());
    } else if (!isByCase()) {
        RangeComparison comparison;
        comparison.against = static_cast<RangeAgainst>(what_->currentIndex() - firstComparison);
        comparison.values = listOf(*values_);
        if (comparison.values.empty())
            throw irsg::InputError(
                {"", tr("Values").toStdString(), "nothing", "values, separated by commas"});
        if (comparison.against == RangeAgainst::paint)
            comparison.paint = paint_->text().trimmed().toStdString();
        if (comparison.against == RangeAgainst::hour && !sunOf_->text().trimmed().isEmpty())
            comparison.place =
                rangePlaceOf(tr("Sun of").toStdString(), sunOf_->text().toStdString());
        request.comparison = std::move(comparison);
    }
}

} // namespace smat::gui

#include "moc_DetectionCasesBox.cpp"
