#include "gui/analysis/MissingForAnalyses.h"

#include <QCoreApplication>

#include "gui/Workbench.h"
#include "gui/database/DatabaseSession.h"

namespace smat::gui {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("smat::gui::MissingForAnalyses", text);
}

} // namespace

QString missingForAnalyses(Workbench& workbench) {
    if (!workbench.hasProject())
        return tr("Open a project, a sample or a model first.");
    if (workbench.project().models.empty())
        return tr("The project has no model: open one.");
    if (workbench.project().models.front().database.empty() && !workbench.database().isOpen())
        return tr("The model has no signature database: make or open one in the dock Signature "
                  "database.");
    return {};
}

} // namespace smat::gui
