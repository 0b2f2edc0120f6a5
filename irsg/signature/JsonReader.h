#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/JsonText.h"
#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/LookupTable.h"

namespace irsg {

/// The diagnostics of one JSON file, gathered while it is read.
class JsonProblems {
  public:
    JsonProblems(std::string fileName, const std::string& text)
        : fileName_(std::move(fileName)), places_(text) {}

    void add(const std::string& path, const nlohmann::json& value, std::string expected);
    void addText(const std::string& path, std::string value, std::string expected);
    /// The diagnostics of `error` again, under the key path they belong to.
    void add(const std::string& path, const InputError& error);
    /// Throws InputError when there are any.
    void throwIfAny() const;

  private:
    std::string fileName_;
    JsonPlaces places_;
    std::vector<Diagnostic> diagnostics_;
};

/// One JSON object under a key path. Each key asked for counts as known; `finish` reports the rest.
/// A value of the wrong kind is reported and answered with a harmless default.
class JsonObject {
  public:
    JsonObject(const nlohmann::json& value, std::string path, JsonProblems& problems);

    const std::string& path() const { return path_; }
    std::string pathOf(const std::string& key) const;
    /// The value of a key, or null. A key that must be there and is not is reported.
    const nlohmann::json* find(const std::string& key, bool required = false);

    std::string text(const std::string& key, bool required = false);
    double number(const std::string& key, double otherwise, bool required = false);
    bool flag(const std::string& key, bool otherwise);
    /// Rows of `columns` numbers each, turned into columns; no value where a row is wrong.
    std::optional<std::vector<std::vector<double>>> columns(const std::string& key,
                                                            std::size_t columns);
    /// {"loop": ..., "nodes": [[x, y], ...]}; an absent key is the empty table.
    LookupTable table(const std::string& key);
    /// A number, or [[wavelength_um, value], ...]; an absent key is the constant `otherwise`.
    Spectrum spectrum(const std::string& key, double otherwise, bool required = false);

    void finish();

  private:
    const nlohmann::json* object_ = nullptr;
    std::string path_;
    JsonProblems* problems_;
    std::set<std::string> known_;
};

} // namespace irsg
