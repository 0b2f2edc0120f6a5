#include "gui/widgets/NumberBoxes.h"

#include <cmath>

#include "gui/widgets/NumberText.h"
#include "gui/widgets/RefusedText.h"

namespace smat::gui {
namespace {

/// What stands before the suffix, which Qt hands over with the text.
template <typename Box>
QString typedIn(const Box& box, QString text) {
    const QString suffix = box.suffix();
    if (!suffix.isEmpty() && text.endsWith(suffix))
        text.chop(suffix.size());
    return text.trimmed();
}

template <typename Box>
QString problemIn(const TypedNumber& typed, double least, double most) {
    if (!typed.value)
        return typed.problem;
    if (*typed.value < least || *typed.value > most)
        return Box::tr("has to be from %1 to %2")
            .arg(QString::number(least, 'g', 15), QString::number(most, 'g', 15));
    return {};
}

} // namespace

RealBox::RealBox(const QString& name, const QString& unit, QWidget* parent)
    : QDoubleSpinBox(parent), unit_(unit) {
    setObjectName(name);
    setSuffix((unit == QChar(0x00b0) ? QString() : QStringLiteral(" ")) + unit);
    setKeyboardTracking(false);
    setCorrectionMode(QAbstractSpinBox::CorrectToPreviousValue);
}

QString RealBox::problemOf(const QString& text) const {
    return problemIn<RealBox>(typedNumber(typedIn(*this, text), unit_), minimum(), maximum());
}

QValidator::State RealBox::validate(QString& text, int&) const {
    return problemOf(text).isEmpty() ? QValidator::Acceptable : QValidator::Intermediate;
}

double RealBox::valueFromText(const QString& text) const {
    return typedNumber(typedIn(*this, text), unit_).value.value_or(value());
}

void RealBox::fixup(QString& text) const {
    sayRefused(*const_cast<RealBox*>(this), problemOf(text), textFromValue(value()) + suffix());
    text = textFromValue(value()) + suffix();
}

WholeBox::WholeBox(const QString& name, QWidget* parent) : QSpinBox(parent) {
    setObjectName(name);
    setKeyboardTracking(false);
    setCorrectionMode(QAbstractSpinBox::CorrectToPreviousValue);
}

QString WholeBox::problemOf(const QString& text) const {
    const TypedNumber typed = typedNumber(typedIn(*this, text));
    if (typed.value && *typed.value != std::trunc(*typed.value))
        return tr("'%1' is not a whole number").arg(typedIn(*this, text));
    return problemIn<WholeBox>(typed, minimum(), maximum());
}

QValidator::State WholeBox::validate(QString& text, int&) const {
    if (!specialValueText().isEmpty() && text == specialValueText())
        return QValidator::Acceptable;
    return problemOf(text).isEmpty() ? QValidator::Acceptable : QValidator::Intermediate;
}

int WholeBox::valueFromText(const QString& text) const {
    if (!specialValueText().isEmpty() && text == specialValueText())
        return minimum();
    return static_cast<int>(typedNumber(typedIn(*this, text)).value.value_or(value()));
}

void WholeBox::fixup(QString& text) const {
    const QString stays = value() == minimum() && !specialValueText().isEmpty()
                              ? specialValueText()
                              : textFromValue(value()) + suffix();
    sayRefused(*const_cast<WholeBox*>(this), problemOf(text), stays);
    text = stays;
}

} // namespace smat::gui

#include "moc_NumberBoxes.cpp"
