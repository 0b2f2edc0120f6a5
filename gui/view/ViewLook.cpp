#include "gui/view/ViewLook.h"

namespace smat::gui {

Settings lookOf(const Project& project, const Settings& settings) {
    for (const NamedAnalysis& analysis : project.analyses) {
        if (analysis.kind != AnalysisKind::image)
            continue;
        const Settings own = settings.with(analysis.settings);
        if (own.text(key::sensorBand) != settings.text(key::sensorBand) ||
            !own.isDefault(key::imageQuantity.name))
            continue;
        Settings look = settings;
        for (const std::string_view key :
             {key::displayScale.name, key::displayMinimum.name, key::displayMaximum.name})
            if (analysis.settings.isSet(key) && !settings.isSet(key))
                look.set(key, analysis.settings.text(key));
        return look;
    }
    return settings;
}

} // namespace smat::gui
