#pragma once

#include <QStringList>

namespace irsg {
class InputError;
}

namespace smat::gui {

/// What is wrong, for a person: "x.smat: line 3: found ..., expected ..." for each offence.
QStringList sentencesOf(const irsg::InputError& error);

} // namespace smat::gui
