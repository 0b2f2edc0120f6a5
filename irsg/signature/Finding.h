#pragma once

#include <functional>
#include <string>

#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// One thing a person should look at.
struct Finding {
    enum class Severity {
        warning, ///< possible, but not likely to be meant
        error    ///< physically wrong: such a database is neither loaded nor saved
    };
    /// Changes nothing where the entry it is about is gone.
    using Repair = std::function<void(SignatureDatabase&)>;

    Severity severity = Severity::error;
    std::string entry; ///< "materials.3" (EntryPath.h), "title", "notes", or "model"
    std::string place; ///< the entry and where in it: "materials.3.emissivity at 4.2 um"
    std::string value;
    std::string reason;   ///< "expected a value from 0 to 1", with why where that is not plain
    std::string remedy;   ///< what would repair it; may be empty
    Repair repair;        ///< does what `remedy` says; empty where a person has to choose
    bool removes = false; ///< `repair` deletes something: only a person may ask for it

    bool isError() const { return severity == Severity::error; }
};

} // namespace irsg
