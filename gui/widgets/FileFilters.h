#pragma once

#include <QStringList>

namespace smat::gui {

/// Filters of a file dialog for what irsg::loadAtmosphere and environment files are read from.
QStringList atmosphereFilters();

} // namespace smat::gui
