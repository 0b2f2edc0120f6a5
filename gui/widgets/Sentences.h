#pragma once

#include <exception>

#include <QStringList>

namespace irsg {
class InputError;
struct Diagnostic;
} // namespace irsg

namespace smat::gui {

/// "a number from 0 to 1 is needed instead of 1.2": the one form of this sentence.
QString neededInstead(const QString& needed, const QString& given);
/// What is wrong, for a person: "x.smat, line 3: a number from 0 to 1 is needed instead of 1.2",
/// and the setting by its name. The terminal has irsg::Diagnostic::message.
QString sentenceOf(const irsg::Diagnostic& diagnostic);
/// One for each diagnostic.
QStringList sentencesOf(const irsg::InputError& error);
/// The same of what work in another thread has thrown; of another fault than that of an input its
/// own words.
QStringList sentencesOf(const std::exception_ptr& thrown);

} // namespace smat::gui
