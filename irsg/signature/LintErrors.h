#pragma once

#include <string>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// The findings of severity error as diagnostics of `file`.
std::vector<Diagnostic> lintErrors(const SignatureDatabase& database, const std::string& file);
/// Throws InputError when there are any.
void throwOnLintErrors(const SignatureDatabase& database, const std::string& file);

} // namespace irsg
