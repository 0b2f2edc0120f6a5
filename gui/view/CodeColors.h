#pragma once

#include <map>

#include <QColor>

#include "gui/widgets/ThemeColors.h"
#include "irsg/geometry/reading/ModelValues.h"

namespace smat::gui {

/// Colours for the faces of a model by one of their two indices.
struct CodeColors {
    bool byMaterial = false;
    std::map<int, QColor> colors;

    int indexOf(const irsg::IrCodes& codes) const {
        return byMaterial ? codes.material : codes.temperature;
    }
    QColor of(const irsg::IrCodes& codes) const {
        const auto found = colors.find(indexOf(codes));
        return found == colors.end() ? colors::unknownIndex() : found->second;
    }
};

} // namespace smat::gui
