#include "gui/database/MaterialLibrary.h"

#include <QFile>

#include "irsg/radiometry/Errors.h"
#include "irsg/signature/SignatureFile.h"

namespace smat::gui {

const irsg::SignatureDatabase& materialLibrary() {
    static const irsg::SignatureDatabase library = [] {
        QFile file(":/materials/library.json");
        if (!file.open(QIODevice::ReadOnly))
            throw irsg::LogicError("no library of materials");
        try {
            return irsg::signatureFromJson(file.readAll().toStdString(), "library.json");
        } catch (const irsg::InputError& error) {
            throw irsg::LogicError(error.what());
        }
    }();
    return library;
}

} // namespace smat::gui
