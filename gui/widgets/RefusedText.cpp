#include "gui/widgets/RefusedText.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QToolTip>

#include "gui/widgets/ThemeColors.h"

namespace smat::gui {

void sayRefused(QWidget& field, const QString& problem, const QString& stays) {
    const QString sentence =
        QCoreApplication::translate("smat::gui::RefusedText", "%1; %2 stays").arg(problem, stays);
    field.setProperty("refused", sentence);
    if (field.isVisible())
        QToolTip::showText(field.mapToGlobal(QPoint(0, field.height())), sentence, &field);
}

void markField(QLineEdit& field, const QString& problem, const QString& help) {
    QPalette colours;
    if (!problem.isEmpty())
        colours.setColor(QPalette::Base, colors::wrongField(colours));
    field.setPalette(colours);
    field.setToolTip(problem.isEmpty() ? help : problem);
}

} // namespace smat::gui
