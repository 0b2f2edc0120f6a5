#include "irsg/signature/MaterialLibrary.h"

#include <string>

#include "irsg/core/Errors.h"
#include "irsg/signature/MaterialLibraryText.h"
#include "irsg/signature/SignatureFile.h"

namespace irsg {

const SignatureDatabase& materialLibrary() {
    static const SignatureDatabase library = [] {
        try {
            return signatureFromJson(std::string(materialLibraryText()), "library.json");
        } catch (const InputError& error) {
            throw LogicError(error.what());
        }
    }();
    return library;
}

} // namespace irsg
