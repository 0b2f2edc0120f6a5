#pragma once

#include <QString>

#include "gui/widgets/Dialogs.h"
#include "irsg/image/ImageFormat.h"

class QWidget;

namespace smat::gui {

/// Asks which of the parts or pages of an image file is meant, where it has several; empty for a
/// file of one image, without an answer, and for one that cannot be read, which its reader says.
irsg::ImageReading chosenImage(const Dialogs& dialogs, QWidget* window, const QString& file);

} // namespace smat::gui
