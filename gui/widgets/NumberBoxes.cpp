#include "gui/widgets/NumberBoxes.h"

#include <cmath>
#include <type_traits>

#include <QCoreApplication>
#include <QRegularExpression>

#include "gui/widgets/NumberText.h"
#include "gui/widgets/RefusedText.h"

namespace smat::gui {
namespace {

QString trBox(const char* text) {
    return QCoreApplication::translate("smat::gui::NumberBoxes", text);
}

} // namespace

template <typename Box>
TypedBox<Box>::TypedBox(const QString& name, const QString& unit, QWidget* parent)
    : Box(parent), unit_(unit) {
    this->setObjectName(name);
    this->setKeyboardTracking(false);
    this->setCorrectionMode(QAbstractSpinBox::CorrectToPreviousValue);
}

/// What stands before the suffix, which Qt hands over with the text.
template <typename Box>
QString TypedBox<Box>::typedIn(const QString& text) const {
    const QString suffix = this->suffix();
    return (suffix.isEmpty() || !text.endsWith(suffix) ? text : text.chopped(suffix.size()))
        .trimmed();
}

template <typename Box>
QString TypedBox<Box>::problemOf(const QString& text) const {
    const TypedNumber typed = typedNumber(typedIn(text), unit_);
    if (!typed.value)
        return typed.problem;
    if (std::is_integral_v<Value> && *typed.value != std::trunc(*typed.value))
        return trBox("'%1' is not a whole number").arg(typedIn(text));
    const double least = this->minimum(), most = this->maximum();
    if (*typed.value < least || *typed.value > most)
        return trBox("has to be from %1 to %2")
            .arg(QString::number(least, 'g', 15), QString::number(most, 'g', 15));
    return {};
}

template <typename Box>
bool TypedBox<Box>::isSpecial(const QString& text) const {
    return !this->specialValueText().isEmpty() && text == this->specialValueText();
}

template <typename Box>
QValidator::State TypedBox<Box>::validate(QString& text, int&) const {
    return isSpecial(text) || problemOf(text).isEmpty() ? QValidator::Acceptable
                                                        : QValidator::Intermediate;
}

template <typename Box>
typename TypedBox<Box>::Value TypedBox<Box>::valueFromText(const QString& text) const {
    if (isSpecial(text))
        return this->minimum();
    return static_cast<Value>(typedNumber(typedIn(text), unit_).value.value_or(this->value()));
}

template <typename Box>
void TypedBox<Box>::fixup(QString& text) const {
    const bool isAtSpecial =
        this->value() == this->minimum() && !this->specialValueText().isEmpty();
    const QString stays = isAtSpecial ? this->specialValueText()
                                      : this->textFromValue(this->value()) + this->suffix();
    sayRefused(*const_cast<TypedBox*>(this), problemOf(text), stays);
    text = stays;
}

template class TypedBox<QDoubleSpinBox>;
template class TypedBox<QSpinBox>;

RealBox::RealBox(const QString& name, const QString& unit, QWidget* parent)
    : TypedBox(name, unit, parent) {
    setSuffix((unit == QChar(0x00b0) ? QString() : QStringLiteral(" ")) + unit);
}

QString RealBox::textFromValue(double value) const {
    QString text = QString::number(value, 'f', decimals());
    if (text.contains('.'))
        text.remove(QRegularExpression("\\.?0+$"));
    return text == "-0" ? QStringLiteral("0") : text;
}

} // namespace smat::gui
