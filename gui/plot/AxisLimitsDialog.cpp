#include "gui/plot/AxisLimitsDialog.h"

#include <optional>

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Widgets.h"
#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

/// What is in a field: the exact end that it began with, whose digits are not all shown, or what
/// has been typed; nothing where that is no number.
std::optional<double> endIn(const QLineEdit* field, double before) {
    return field->text() == formattedNumber(before) ? before : numberIn(field);
}

} // namespace

AxisLimitsDialog::AxisLimitsDialog(const std::vector<Axis>& axes, QWidget* parent)
    : QDialog(parent) {
    setObjectName("axisLimitsDialog");
    setWindowTitle(tr("Axis limits"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(8);
    for (const auto& [column, text] : {std::pair(1, tr("from")), std::pair(2, tr("to"))}) {
        auto* head = new QLabel(text, this);
        head->setForegroundRole(QPalette::PlaceholderText);
        grid->addWidget(head, 0, column);
    }
    for (const Axis& axis : axes) {
        const int line = static_cast<int>(rows_.size()) + 1;
        const auto field = [&](double value, const char* end, int column) {
            auto* edit = new QLineEdit(formattedNumber(value), this);
            edit->setObjectName(QStringLiteral("limit%1%2").arg(line).arg(end));
            edit->setMinimumWidth(130);
            connect(edit, &QLineEdit::textChanged, this, &AxisLimitsDialog::refresh);
            grid->addWidget(edit, line, column);
            return edit;
        };
        auto* label = new QLabel(axis.title, this);
        grid->addWidget(label, line, 0, Qt::AlignRight);
        auto* from = field(axis.limits.minimum, "From", 1);
        label->setBuddy(from);
        rows_.push_back({axis, from, field(axis.limits.maximum, "To", 2)});
    }
    problems_ = new QLabel(this);
    problems_->setObjectName("problems");
    problems_->setWordWrap(true);
    buttons_ = okAndCancel(*this);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 14);
    column->setSpacing(12);
    column->addLayout(grid);
    column->addWidget(problems_);
    column->addStretch(1);
    column->addWidget(buttons_);
    refresh();
}

QStringList AxisLimitsDialog::problems() const {
    QStringList list;
    for (const Row& row : rows_) {
        const auto from = endIn(row.from, row.axis.limits.minimum);
        const auto to = endIn(row.to, row.axis.limits.maximum);
        if (!from || !to)
            list << tr("%1: two numbers, such as 0.5 and 1e4").arg(row.axis.title);
        else if (!(*from < *to))
            list << tr("%1: the first must be less than the second").arg(row.axis.title);
        else if (row.axis.positive && *from <= 0.0)
            list << tr("%1: a logarithmic axis begins above 0").arg(row.axis.title);
    }
    return list;
}

std::vector<Interval> AxisLimitsDialog::limits() const {
    std::vector<Interval> list;
    for (const Row& row : rows_)
        list.push_back({endIn(row.from, row.axis.limits.minimum).value_or(0.0),
                        endIn(row.to, row.axis.limits.maximum).value_or(1.0)});
    return list;
}

void AxisLimitsDialog::refresh() {
    if (buttons_ == nullptr)
        return;
    const QStringList wrong = problems();
    problems_->setText(wrong.join('\n'));
    problems_->setVisible(!wrong.isEmpty());
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(wrong.isEmpty());
}

} // namespace smat::gui

#include "moc_AxisLimitsDialog.cpp"
