#include "gui/widgets/RefusedText.h"

#include <QCoreApplication>
#include <QToolTip>
#include <QWidget>

namespace smat::gui {

void sayRefused(QWidget& field, const QString& problem, const QString& stays) {
    const QString sentence =
        QCoreApplication::translate("smat::gui::RefusedText", "%1; %2 stays").arg(problem, stays);
    field.setProperty("refused", sentence);
    if (field.isVisible())
        QToolTip::showText(field.mapToGlobal(QPoint(0, field.height())), sentence, &field);
}

} // namespace smat::gui
