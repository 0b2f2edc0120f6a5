#include "gui/analysis/MissingForAnalyses.h"

#include <QCoreApplication>

#include "gui/Workbench.h"
#include "gui/database/DatabaseSession.h"

namespace smat::gui {
namespace {

struct Missing {
    Q_DECLARE_TR_FUNCTIONS(smat::gui::MissingForAnalyses)
};

} // namespace

QString missingForAnalyses(Workbench& workbench) {
    if (!workbench.hasProject())
        return Missing::tr("Open a project, a sample or a model first.");
    if (workbench.project().models.empty())
        return Missing::tr("The project has no model: open one.");
    if (workbench.project().models.front().database.empty() && !workbench.database().isOpen())
        return Missing::tr(
            "The model has no signature database: make or open one in the dock Signature "
            "database.");
    return {};
}

} // namespace smat::gui
