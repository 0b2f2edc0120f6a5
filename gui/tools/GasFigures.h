#pragma once

#include <QString>

#include "smatcore/tools/GasOutput.h"

namespace smat::gui {

/// The numbers of the band in a few lines: radiance with its stated error, transmittance, what each
/// gas adds and who answered for it, RADCAL, and warnings.
QString gasFigures(const GasOutput& output);

} // namespace smat::gui
