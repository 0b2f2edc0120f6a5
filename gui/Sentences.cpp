#include "gui/Sentences.h"

#include "irsg/radiometry/Errors.h"

namespace smat::gui {

QStringList sentencesOf(const irsg::InputError& error) {
    QStringList sentences;
    for (const irsg::Diagnostic& diagnostic : error.diagnostics())
        sentences << QString::fromStdString(diagnostic.message());
    return sentences;
}

QStringList sentencesOf(const std::exception_ptr& thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const irsg::InputError& error) {
        return sentencesOf(error);
    } catch (const std::exception& error) {
        return {QString::fromLocal8Bit(error.what())};
    }
}

} // namespace smat::gui
