#pragma once

#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "irsg/signature/EntryPath.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// The JSON form of docs/formats-sigdb.md, entry by entry. Keys of objects are sorted; empty tables
/// and lists are left out, everything else is written.
nlohmann::json entryJson(const TemperatureEntry& entry);
nlohmann::json entryJson(const Material& material);
/// The components must share one axis (LogicError): lint says so before.
nlohmann::json entryJson(const UserSpectrum& spectrum);

/// The canonical text of every entry under its path: "title", "notes", "temperatures.1",
/// "materials.3", "spectra.plume". Equal entries have equal text on every machine.
std::map<std::string, std::string> canonicalEntries(const SignatureDatabase& database);

} // namespace irsg
