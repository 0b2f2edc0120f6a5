#include "gui/analysis/AnalysisPreconditions.h"

#include <QCoreApplication>

#include "gui/database/DatabaseSession.h"
#include "gui/workbench/Workbench.h"

namespace smat::gui {
namespace {

struct Missing {
    Q_DECLARE_TR_FUNCTIONS(smat::gui::AnalysisPreconditions)
};

} // namespace

QString missingPreconditions(Workbench& workbench) {
    if (!workbench.hasProject())
        return Missing::tr("Open a project, a sample or a model first.");
    if (workbench.project().models.empty())
        return Missing::tr("The project has no model: open one.");
    const auto& models = workbench.project().models;
    for (std::size_t i = 0; i < models.size(); ++i) {
        if (!models[i].database.empty() ||
            (i == workbench.chosenModel() && workbench.database().isOpen()))
            continue;
        if (models.size() == 1)
            return Missing::tr("The model has no signature database: File → First signature from "
                               "names… makes one, or open one in the panel Signature database.");
        return Missing::tr("The model %1 has no signature database: choose the model in the "
                           "scene; File → First signature from names… then makes one, or open "
                           "one in the panel Signature database.")
            .arg(QString::fromStdString(models[i].shownName()));
    }
    return {};
}

} // namespace smat::gui
