#include "gui/image/ThresholdForm.h"

#include <cmath>
#include <limits>
#include <optional>

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Widgets.h"
#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

const char* const columnNames[] = {"fail", "warn"};
const char* const rowNames[] = {"Absolute", "Relative", "Percent", "Hard", "Allowed"};

} // namespace

ThresholdForm::ThresholdForm(QWidget* parent) : QWidget(parent) {
    setObjectName("thresholds");
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(10);
    grid->setColumnStretch(0, 1);
    for (const int column : {1, 2})
        grid->setColumnStretch(column, 1);
    grid->setVerticalSpacing(6);
    const QString titles[] = {tr("Failure"), tr("Warning")};
    for (int c = 0; c < 2; ++c)
        grid->addWidget(new QLabel("<b>" + titles[c] + "</b>", this), 0, c + 1);
    const QString tips[] = {tr("A pixel is over the threshold where |A − B| is larger than this"),
                            tr("… and |A − B| / ½(|A| + |B|) is larger than this, 0 to 2"),
                            tr("Allowed fraction of pixels over the threshold, in percent"),
                            tr("A single pixel with a larger |A − B| is a failure, whatever "
                               "fraction is allowed; empty: no limit"),
                            tr("Allowed number of pixels over the threshold")};
    for (std::size_t r = 0; r < rowCount; ++r) {
        names_[r] = new QLabel(this);
        names_[r]->setWordWrap(true);
        grid->addWidget(names_[r], static_cast<int>(r) + 1, 0);
        for (std::size_t c = 0; c < 2; ++c) {
            auto* field = new QLineEdit(this);
            field->setObjectName(QString(columnNames[c]) + rowNames[r]);
            field->setToolTip(tips[r]);
            field->setMinimumWidth(60);
            if (r == hard)
                field->setPlaceholderText(tr("none"));
            fields_[c][r] = field;
            grid->addWidget(field, static_cast<int>(r) + 1, static_cast<int>(c) + 1);
            connect(field, &QLineEdit::editingFinished, this, &ThresholdForm::read);
        }
        names_[r]->setToolTip(tips[r]);
    }
    wrong_ = new QLabel(this);
    wrong_->setObjectName("thresholdsWrong");
    wrong_->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->addLayout(grid);
    column->addWidget(wrong_);
    column->addStretch(1);
    setUnit({});
    write();
}

void ThresholdForm::setUnit(const QString& unit) {
    const QString behind = unit.isEmpty() ? QString() : " (" + unit + ")";
    const QString texts[] = {tr("|A − B| over") + behind, tr("and relative over"),
                             tr("allowed part (%)"), tr("no pixel over") + behind,
                             tr("allowed number (px)")};
    for (std::size_t r = 0; r < rowCount; ++r)
        names_[r]->setText(texts[r]);
}

void ThresholdForm::write() {
    for (std::size_t c = 0; c < 2; ++c) {
        const irsg::ComparisonLevel& level = levels_[c];
        const QString texts[] = {exactNumber(level.absolute), exactNumber(level.relative),
                                 exactNumber(level.percent), exactNumber(level.hard),
                                 QString::number(level.allowed)};
        for (std::size_t r = 0; r < rowCount; ++r)
            fields_[c][r]->setText(texts[r]);
    }
}

std::optional<irsg::ComparisonLevel> ThresholdForm::levelIn(std::size_t column,
                                                            QStringList& wrong) const {
    irsg::ComparisonLevel level;
    double* const numbers[] = {&level.absolute, &level.relative, &level.percent, &level.hard};
    const qsizetype before = wrong.size();
    const auto refuse = [&](std::size_t row, const QString& expected) {
        const QString word = column == 0 ? tr("Failure") : tr("Warning");
        wrong << QStringLiteral("%1, %2: %3")
                     .arg(word, names_[row]->text(),
                          neededInstead(expected,
                                        QStringLiteral("“%1”").arg(fields_[column][row]->text())));
    };
    for (std::size_t r = absolute; r <= hard; ++r) {
        const std::string text = fields_[column][r]->text().trimmed().toStdString();
        if (r == hard && text.empty())
            level.hard = std::numeric_limits<double>::infinity();
        else if (const auto number = numberIn(fields_[column][r]))
            *numbers[r] = *number;
        else
            refuse(r, tr("a number"));
    }
    bool whole = false;
    level.allowed = fields_[column][allowed]->text().trimmed().toULongLong(&whole);
    if (!whole)
        refuse(allowed, tr("a whole number from 0"));
    return wrong.size() == before ? std::optional(level) : std::nullopt;
}

void ThresholdForm::read() {
    QStringList wrong;
    const auto fail = levelIn(0, wrong), warn = levelIn(1, wrong);
    if (fail && warn) {
        irsg::ComparisonOptions options;
        options.fail = *fail;
        options.warn = *warn;
        try {
            options.check();
        } catch (const irsg::InputError& error) {
            wrong << sentencesOf(error);
        }
    }
    wrong_->setText(wrong.join('\n'));
    if (!wrong.isEmpty() || (*fail == levels_[0] && *warn == levels_[1]))
        return;
    levels_ = {*fail, *warn};
    emit changed();
}

QString ThresholdForm::options() const {
    QString text;
    const irsg::ComparisonLevel none;
    for (std::size_t c = 0; c < 2; ++c) {
        const QString word = columnNames[c];
        const auto add = [&](const QString& option, double value, double usual) {
            if (value != usual)
                text += " --" + option + " " + exactNumber(value);
        };
        add(word, levels_[c].absolute, none.absolute);
        add(word + "-relative", levels_[c].relative, none.relative);
        add(word + "-percent", levels_[c].percent, none.percent);
        add("hard-" + word, levels_[c].hard, none.hard);
        add(c == 0 ? "allow-failures" : "allow-warnings", static_cast<double>(levels_[c].allowed),
            0.0);
    }
    return text;
}

} // namespace smat::gui

#include "moc_ThresholdForm.cpp"
