#include "gui/widgets/NumberField.h"

#include <algorithm>

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>

#include "gui/widgets/NumberText.h"
#include "gui/widgets/RefusedText.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"

namespace smat::gui {

NumberField::NumberField(const QString& unit, QWidget* parent) : QLineEdit(parent), unit_(unit) {
    setMinimumWidth(fontMetrics().horizontalAdvance("00000.000 " + unit) + 14);
    setText("0");
    if (!unit_.isEmpty())
        setTextMargins(0, 0, fontMetrics().horizontalAdvance(unit_) + 8, 0);
    connect(this, &QLineEdit::textEdited, this, &NumberField::onText);
    connect(this, &QLineEdit::editingFinished, this, &NumberField::finish);
}

void NumberField::setRange(double minimum, double maximum) {
    minimum_ = minimum;
    maximum_ = maximum;
}

void NumberField::setValue(double value) {
    const auto shown = typedNumber(text(), unit_, meaning()).value;
    if (shown && *shown == value && value == value_)
        return;
    value_ = value;
    setText(textOf(value));
    mark({});
}

void NumberField::onText(const QString& text) {
    if (!before_)
        before_ = value_;
    const TypedNumber typed = typedNumber(text, unit_, meaning());
    const auto number = typed.value;
    if (!number)
        return mark(typed.problem);
    if (const QString problem = check_ ? check_(*number) : QString(); !problem.isEmpty())
        return mark(problem);
    if (*number < minimum_ || *number > maximum_) {
        if (maximum_ == std::numeric_limits<double>::infinity())
            return mark(tr("has to be at least %1 %2").arg(textOf(minimum_), unit_).trimmed());
        if (minimum_ == -std::numeric_limits<double>::infinity())
            return mark(tr("has to be at most %1 %2").arg(textOf(maximum_), unit_).trimmed());
        return mark(tr("has to be from %1 to %2 %3")
                        .arg(textOf(minimum_), textOf(maximum_), unit_)
                        .trimmed());
    }
    mark({});
    if (*number != value_) {
        value_ = *number;
        emit edited(value_);
    }
}

void NumberField::mark(const QString& problem) {
    if (problem == problem_)
        return;
    if (problem_.isEmpty())
        help_ = toolTip();
    problem_ = problem;
    setToolTip(problem.isEmpty() ? help_ : problem);
    QPalette colours = QApplication::palette(this);
    if (!problem.isEmpty())
        colours.setColor(QPalette::Base, colors::wrongField(colours));
    setPalette(problem.isEmpty() ? QPalette() : colours);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    if (isReadOnly() || (event->key() != Qt::Key_Up && event->key() != Qt::Key_Down)) {
        QLineEdit::keyPressEvent(event);
        return;
    }
    const double fine = event->modifiers() & Qt::ShiftModifier ? 0.1 : 1.0;
    const double moved = value_ + (event->key() == Qt::Key_Up ? step_ : -step_) * fine;
    setText(textOf(QString::number(std::clamp(moved, minimum_, maximum_), 'g', 12).toDouble()));
    onText(text());
}

void NumberField::finish() {
    const double before = before_.value_or(value_);
    before_.reset();
    if (!isRight()) {
        const bool differs = before != value_;
        sayRefused(*this, problem_, textOf(before));
        value_ = before;
        setText(textOf(value_));
        mark({});
        if (differs)
            emit edited(value_);
    }
    emit finished();
}

void NumberField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (unit_.isEmpty())
        return;
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(0, 0, -7, 0), Qt::AlignRight | Qt::AlignVCenter, unit_);
}

} // namespace smat::gui

#include "moc_NumberField.cpp"
