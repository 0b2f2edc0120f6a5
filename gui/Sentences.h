#pragma once

#include <exception>

#include <QStringList>

namespace irsg {
class InputError;
}

namespace smat::gui {

/// What is wrong, for a person: "x.smat: line 3: found ..., expected ..." for each diagnostic.
QStringList sentencesOf(const irsg::InputError& error);
/// The same of what work in another thread has thrown; of another fault than that of an input its
/// own words.
QStringList sentencesOf(const std::exception_ptr& thrown);

} // namespace smat::gui
