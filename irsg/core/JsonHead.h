#pragma once

#include <string>

#include "irsg/core/JsonReader.h"

namespace irsg {

/// Reads the head of a file in a format of our own: `format`, the only `version` that there is, and
/// `program`, which is not looked at. Throws InputError with what is refused so far, so that a file
/// of another kind or version is refused for that alone.
void readJsonHead(const JsonReader& root, const std::string& format, int version);

} // namespace irsg
