#pragma once

#include <string_view>
#include <vector>

#include "irsg/atmosphere/AtmosphereSmartParameters.h"
#include "irsg/core/Errors.h"

namespace irsg {

/// Gives the parameter of a name the value of a text as `valueText` writes it: a number, numbers
/// with blanks or commas between them, words. Names are those of the file, in any case of letters.
/// A diagnostic, and no change, where there is no such parameter or the text is no value of its
/// kind; ranges are for `diagnosticsOf`.
void setFromText(AtmosphereSmartParameters& parameters, std::string_view name,
                 std::string_view text, std::vector<Diagnostic>& diagnostics);

} // namespace irsg
