#include "gui/image/ComparisonReport.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>

#include "gui/image/ComparisonCommand.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/HistogramPlot.h"
#include "gui/image/ImageInspector.h"
#include "gui/image/ThresholdForm.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/ThemeColors.h"
#include "irsg/image/ComparisonFigures.h"

namespace smat::gui {
namespace {

/// Sums are values, which have units of display; errors stay in their own.
bool isValue(const irsg::ComparisonFigure& figure) {
    return figure.key.ends_with("_a") || figure.key.ends_with("_b");
}

QString cell(const irsg::ComparisonFigure& figure) {
    if (isValue(figure) && shownUnitOf(figure.unit) != nullptr)
        return valueWithUnit(figure.value, figure.unit);
    QString unit = QString::fromStdString(figure.unit);
    if (unit.endsWith(" px"))
        unit = formattedUnit(unit.chopped(3).toStdString()) + "·px";
    else
        unit = formattedUnit(figure.unit);
    return (QString::fromStdString(irsg::shortNumber(figure.value)) + " " + unit).trimmed();
}

QString detail(const irsg::ComparisonFigure& figure, const irsg::Comparison& comparison) {
    // Of the largest errors the two values are behind their place.
    const irsg::PixelPair* pair = figure.key == "max_error"            ? &comparison.largest
                                  : figure.key == "max_relative_error" ? &comparison.largestRelative
                                                                       : nullptr;
    QString text = QString::fromStdString(figure.detail);
    if (const qsizetype values = text.indexOf(", A ");
        pair != nullptr && values > 0 && shownUnitOf(comparison.unit) != nullptr)
        return ComparisonReport::tr("%1, A %2, B %3")
            .arg(text.left(values), valueWithUnit(pair->a, comparison.unit),
                 valueWithUnit(pair->b, comparison.unit));
    if (!comparison.unit.empty())
        text.replace(QString::fromStdString(comparison.unit), formattedUnit(comparison.unit));
    return text;
}

/// Whether somebody has said what counts as a failure, or values are missing.
bool isJudged(const ComparedPair& pair) {
    const irsg::ComparisonLevel untouched;
    const auto& whole = pair.whole();
    const bool hasHoles = whole && (whole->nonFiniteA.nan + whole->nonFiniteA.infinite +
                                    whole->nonFiniteB.nan + whole->nonFiniteB.infinite) > 0;
    return pair.options().fail != untouched || pair.options().warn != untouched || hasHoles;
}

} // namespace

ComparisonReport::ComparisonReport(QWidget* parent) : QWidget(parent) {
    verdict_ = new QLabel(this);
    verdict_->setObjectName("verdict");
    verdict_->setAlignment(Qt::AlignCenter);
    sentence_ = new QLabel(this);
    sentence_->setObjectName("verdictSentence");
    sentence_->setWordWrap(true);
    sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    numbers_ = new FiguresTable(this);
    numbers_->setObjectName("comparisonNumbers");
    inspector_ = new ImageInspector(this);
    inspector_->setTableBelow(true);
    tabs_ = new QTabWidget(this);
    tabs_->setObjectName("comparisonTabs");
    tabs_->setDocumentMode(true);
    tabs_->setStyleSheet("QTabBar::tab { padding: 7px 8px; }"); // beside narrow images, too
    tabs_->addTab(numbers_, tr("Numbers"));
    tabs_->addTab(makeThresholdsTab(), tr("Thresholds"));
    tabs_->addTab(inspector_, tr("Histogram"));

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* row = new QHBoxLayout;
    row->setSpacing(10);
    row->addWidget(verdict_, 0, Qt::AlignTop);
    row->addWidget(sentence_, 1);
    column->addLayout(row);
    column->addWidget(tabs_, 1);
}

QWidget* ComparisonReport::makeThresholdsTab() {
    auto* judged = new QWidget(this);
    thresholds_ = new ThresholdForm(judged);
    command_ = new ComparisonCommand(judged);
    auto* below = new QVBoxLayout(judged);
    below->setContentsMargins(0, 0, 0, 0);
    below->setSpacing(0);
    below->addWidget(thresholds_, 1);
    below->addWidget(command_);
    // Where the page is low it scrolls, and fields keep their height.
    auto* scroll = new QScrollArea(this);
    scroll->setObjectName("thresholdsScroll");
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidgetResizable(true);
    scroll->setWidget(judged);
    scroll->viewport()->setAutoFillBackground(false);
    judged->setAutoFillBackground(false);
    return scroll;
}

void ComparisonReport::toggle(Tab tab) {
    tabs_->setCurrentIndex(tabs_->currentIndex() == tab ? numbersTab : tab);
}

void ComparisonReport::show(const ComparedPair& pair) {
    showNumbers(pair);
    showVerdict(pair);
}

void ComparisonReport::showNumbers(const ComparedPair& pair) {
    const auto& whole = pair.whole();
    const auto& part = pair.part();
    if (!whole) {
        numbers_->setFigures({}, {});
        return;
    }
    thresholds_->setUnit(formattedUnit(whole->unit));
    const auto figures = irsg::comparisonFigures(*whole, pair.options());
    const auto ofPart = part ? irsg::comparisonFigures(*part, pair.options())
                             : std::vector<irsg::ComparisonFigure>();
    QStringList headings{tr("Statistic"), tr("Image")};
    if (part)
        headings << tr("Rectangle");
    headings << tr("Detail");
    QList<QStringList> rows;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        if (figures[i].label.empty()) {
            // A percentage belongs to the number of pixels above it.
            rows.back()[1] += " (" + cell(figures[i]) + ")";
            if (part)
                rows.back()[2] += " (" + cell(ofPart[i]) + ")";
            continue;
        }
        const QString label = QString::fromStdString(figures[i].label).replace(" - ", " − ");
        QStringList row{label, cell(figures[i])};
        if (part) {
            const bool hasPlace = ofPart[i].key.starts_with("max_") && ofPart[i].value != 0.0;
            row << cell(ofPart[i]) + (hasPlace ? ", " + detail(ofPart[i], *part) : QString());
        }
        rows << (row << detail(figures[i], *whole));
    }
    numbers_->setFigures(headings, rows);
}

void ComparisonReport::showVerdict(const ComparedPair& pair) {
    const bool compared = pair.whole().has_value();
    verdict_->setVisible(compared || !pair.refusal().isEmpty());
    if (!compared) {
        verdict_->setText(tr("REFUSED"));
        sentence_->setText(!pair.refusal().isEmpty() ? pair.refusal()
                           : pair.isComparing()
                               ? tr("Comparing …")
                               : tr("Open two images of the same size, or drop two files here: "
                                    "OpenEXR, CSV, or a matrix of numbers."));
    } else {
        const irsg::Comparison& c = pair.part() ? *pair.part() : *pair.whole();
        const bool isOther = c.verdict == irsg::Verdict::failure && !isJudged(pair);
        verdict_->setText(isOther ? tr("DIFFERENT")
                                  : QString::fromStdString(irsg::verdictWord(c.verdict)));
        const QString where = pair.part() ? tr("Rectangle: ") : QString();
        QString text =
            isOther ? tr("%1%2 px (%3 %) differ. Thresholds say which difference is a failure.")
                          .arg(where)
                          .arg(c.overFail)
                          .arg(c.percentOverFail(), 0, 'g', 3)
                    : tr("%1%2 px (%3 %) exceed the failure threshold, %4 px (%5 %) the warning "
                         "threshold.")
                          .arg(where)
                          .arg(c.overFail)
                          .arg(c.percentOverFail(), 0, 'g', 3)
                          .arg(c.overWarn)
                          .arg(c.percentOverWarn(), 0, 'g', 3);
        for (const std::string& warning : c.warnings)
            text += " " + tr("Note: %1.").arg(QString::fromStdString(warning));
        sentence_->setText(text);
    }
    const bool pass = compared && verdict_->text() == "PASS";
    const bool warning = compared && verdict_->text() == "WARNING";
    verdict_->setStyleSheet(
        QStringLiteral("QLabel { background: %1; color: white; font-weight: bold; "
                       "border-radius: 4px; padding: 4px 12px; }")
            .arg((pass                                              ? colors::verdictPass()
                  : warning                                         ? colors::verdictWarning()
                  : compared && verdict_->text() == tr("DIFFERENT") ? colors::verdictDifferent()
                                                                    : colors::verdictFailure())
                     .name()));
}

} // namespace smat::gui

#include "moc_ComparisonReport.cpp"
