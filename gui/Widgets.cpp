#include "gui/Widgets.h"

#include <cmath>

#include <QLineEdit>
#include <QToolButton>

#include "irsg/radiometry/CsvTable.h"

namespace smat::gui {

QToolButton* textButton(const QString& text, const QString& objectName, const QString& toolTip) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setObjectName(objectName);
    button->setToolTip(toolTip);
    return button;
}

std::optional<double> numberIn(const QLineEdit* field) {
    const auto number = irsg::parseNumber(field->text().trimmed().toStdString());
    return number && std::isfinite(*number) ? number : std::nullopt;
}

} // namespace smat::gui
