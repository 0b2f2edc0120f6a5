#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include "gui/Readable.h"
#include "gui/image/ComparisonPanes.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/ImageExport.h"
#include "gui/image/ThresholdForm.h"
#include "irsg/image/ComparisonFigures.h"

namespace smat::gui {
namespace {

QString cell(const irsg::ComparisonFigure& figure) {
    QString unit = QString::fromStdString(figure.unit);
    if (unit.endsWith(" px"))
        unit = readableUnit(unit.chopped(3).toStdString()) + "·px";
    else
        unit = readableUnit(figure.unit);
    return (QString::fromStdString(irsg::shortNumber(figure.value)) + " " + unit).trimmed();
}

QString detail(const irsg::ComparisonFigure& figure, const irsg::Comparison& comparison) {
    QString text = QString::fromStdString(figure.detail);
    if (!comparison.unit.empty())
        text.replace(QString::fromStdString(comparison.unit), readableUnit(comparison.unit));
    return text;
}

} // namespace

void ComparisonWindow::take(Answer answer) {
    marks_ = std::move(answer.marks);
    use(std::move(answer.whole), std::move(answer.part));
    showMarks();
}

void ComparisonWindow::use(std::optional<irsg::Comparison> whole,
                           std::optional<irsg::Comparison> part) {
    whole_ = std::move(whole);
    part_ = std::move(part);
    thresholds_->setUnit(readableUnit(whole_->unit));

    const auto figures = irsg::comparisonFigures(*whole_, options_);
    const auto ofPart =
        part_ ? irsg::comparisonFigures(*part_, options_) : std::vector<irsg::ComparisonFigure>();
    QStringList headings{tr("Figure"), tr("Image")};
    if (part_)
        headings << tr("Rectangle");
    headings << tr("Detail");
    QList<QStringList> rows;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        if (figures[i].label.empty()) {
            // A percentage belongs to the number of pixels above it.
            rows.back()[1] += " (" + cell(figures[i]) + ")";
            if (part_)
                rows.back()[2] += " (" + cell(ofPart[i]) + ")";
            continue;
        }
        const QString label = QString::fromStdString(figures[i].label).replace(" - ", " − ");
        QStringList row{label, cell(figures[i])};
        if (part_) {
            const bool hasPlace = ofPart[i].key.starts_with("max_") && ofPart[i].value != 0.0;
            row << cell(ofPart[i]) + (hasPlace ? ", " + detail(ofPart[i], *part_) : QString());
        }
        rows << (row << detail(figures[i], *whole_));
    }
    numbers_->setFigures(headings, rows);
    showVerdict();
}

void ComparisonWindow::showCommand() {
    const QString command = commandLine();
    const bool isThere = !command.isEmpty();
    commandPart_->setVisible(sides_[0].image && sides_[1].image);
    commandWords_->setText(isThere ? tr("The same from a terminal")
                                   : tr("The same from a terminal: save each result as .exr first, "
                                        "then compare them again."));
    command_->setText(command);
    command_->setToolTip(command);
    command_->setCursorPosition(0);
    for (QWidget* widget : {static_cast<QWidget*>(command_), static_cast<QWidget*>(copyCommand_)})
        widget->setVisible(isThere);
    copyCommandAction_->setEnabled(isThere);
}

void ComparisonWindow::showVerdict() {
    showCommand();
    const bool compared = whole_.has_value();
    for (QWidget* button : {static_cast<QWidget*>(worst_), static_cast<QWidget*>(copy_),
                            static_cast<QWidget*>(export_), static_cast<QWidget*>(mark_)})
        button->setEnabled(compared);
    swap_->setEnabled(sides_[0].image || sides_[1].image);
    modeBox_->setEnabled(difference_ != nullptr);
    plane_->setEnabled(plane_->count() > 1);
    verdict_->setVisible(compared || !refusal_.isEmpty());
    if (!compared) {
        numbers_->setFigures({}, {});
        verdict_->setText(tr("REFUSED"));
        sentence_->setText(!refusal_.isEmpty() ? refusal_
                           : compareTask_.isBusy()
                               ? tr("Comparing …")
                               : tr("Open two images of the same size, or drop two files here: "
                                    "OpenEXR, CSV, or a matrix of numbers."));
    } else {
        const irsg::Comparison& c = part_ ? *part_ : *whole_;
        const bool isOther = c.verdict == irsg::Verdict::failure && !isJudged();
        verdict_->setText(isOther ? tr("DIFFERENT")
                                  : QString::fromStdString(irsg::verdictWord(c.verdict)));
        const QString where = part_ ? tr("Rectangle: ") : QString();
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
            .arg(pass                                              ? "#1f8a4c"
                 : warning                                         ? "#b36b00"
                 : compared && verdict_->text() == tr("DIFFERENT") ? "#56657a"
                                                                   : "#c2283c"));
}

bool ComparisonWindow::isJudged() const {
    const irsg::ComparisonLevel untouched;
    const bool hasHoles = whole_ && (whole_->nonFiniteA.nan + whole_->nonFiniteA.infinite +
                                     whole_->nonFiniteB.nan + whole_->nonFiniteB.infinite) > 0;
    return options_.fail != untouched || options_.warn != untouched || hasHoles;
}

void ComparisonWindow::showMarks() {
    panes_->setMarks(mark_->isChecked() && difference_ ? marks_ : std::vector<std::uint8_t>());
}

QString ComparisonWindow::readoutAt(int x, int y) const {
    QString text = QStringLiteral("x %1   y %2").arg(x).arg(y);
    std::array<double, 2> values{};
    for (std::size_t i = 0; i < 2; ++i) {
        const irsg::ImageChannel* plane = planeOf(i);
        if (plane == nullptr || x >= sides_[i].image->width() || y >= sides_[i].image->height())
            continue;
        values[i] = static_cast<double>(plane->values[sides_[i].image->offset(x, y)]);
        text += QStringLiteral("          %1  %2 %3")
                    .arg(i == 0 ? "A" : "B", readableNumber(values[i]), readableUnit(plane->unit));
    }
    if (difference_ && !differenceTask_.isBusy())
        text += QStringLiteral("          %1  %2 %3")
                    .arg(differenceName(mode_),
                         readableNumber(irsg::difference(values[0], values[1], mode_)),
                         readableUnit(difference_->primary().unit));
    return text.trimmed();
}

void ComparisonWindow::showReadout(std::optional<QPoint> pixel) {
    pixel_ = pixel;
    readout_->setText(pixel ? readoutAt(pixel->x(), pixel->y())
                            : tr("Move the mouse over an image, or press the arrows, to read its "
                                 "pixels. Hold Space to see B in the place of A."));
}

} // namespace smat::gui
