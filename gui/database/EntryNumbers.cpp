#include "gui/database/EntryNumbers.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace smat::gui {

NumberField* makeNumberField(const char* key, const char* unit, const char* help,
                             const irsg::NumberRules& rules, QWidget* parent) {
    auto* field = new NumberField(unit, parent);
    field->setObjectName(key);
    field->setRange(rules.least, rules.most);
    field->setStep(rules.step);
    field->setToolTip(QCoreApplication::translate("EntryFields", help));
    return field;
}

QLabel* makeFieldLabel(const char* label, QWidget* parent) {
    static const QRegularExpression index("(?<=[A-Za-z])(\\d+)");
    QString text = QCoreApplication::translate("EntryFields", label);
    auto* made = new QLabel(text.replace(index, "<sub>\\1</sub>"), parent);
    made->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return made;
}

} // namespace smat::gui
