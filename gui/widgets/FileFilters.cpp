#include "gui/widgets/FileFilters.h"

#include <QCoreApplication>

namespace smat::gui {

QStringList atmosphereFilters() {
    const auto words = [](const char* text) {
        return QCoreApplication::translate("smat::gui::FileFilters", text);
    };
    return {words("Atmospheres (*.xml *.csv *.smatatm *.json *tape7* *.fl7 *.tp7 *.scn)"),
            words("All files (*)")};
}

} // namespace smat::gui
