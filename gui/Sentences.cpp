#include "gui/Sentences.h"

#include "irsg/radiometry/Errors.h"

namespace smat::gui {

QStringList sentencesOf(const irsg::InputError& error) {
    QStringList sentences;
    for (const irsg::Offence& offence : error.offences())
        sentences << QString::fromStdString(offence.message());
    return sentences;
}

} // namespace smat::gui
