#include "irsg/geometry/reading/ModelCodes.h"

#include <algorithm>
#include <sstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/JsonHead.h"
#include "irsg/core/JsonReader.h"
#include "irsg/core/ProgramVersion.h"

namespace irsg {
namespace {

using nlohmann::json;

/// A name that is no UTF-8 is in no rule of ours, but is no reason to give up.
std::string textOf(const json& value) {
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

constexpr const char* formatName = "smat-codes";
constexpr int newestVersion = 1;
constexpr double farthestCorner = 1e9;

GivenCodes givenIn(const JsonReader& object) {
    const auto indexOf = [&](const char* key) {
        return object.at(key).indexIfAny("the index of an entry, a whole number");
    };
    const GivenCodes codes{indexOf("temperatureIndex"), indexOf("materialIndex")};
    if (!object.has("temperatureIndex") && !object.has("materialIndex"))
        object.refuse("no index", "temperatureIndex, materialIndex or both");
    return codes;
}

CodeRule ruleOf(const JsonReader& object) {
    CodeRule rule;
    int found = 0;
    for (std::size_t i = 0; i < codeRuleNames().size(); ++i)
        if (const JsonReader pattern = object.at(codeRuleNames()[i]); pattern.exists()) {
            rule.of = static_cast<CodeRule::Of>(i);
            rule.pattern = pattern.text();
            ++found;
        }
    if (found != 1)
        object.refuse(found == 0 ? "a rule for nothing" : "a rule for several",
                      "one of material, object and group");
    rule.codes = givenIn(object);
    object.refuseUnknown();
    return rule;
}

PaintedSurface surfaceOf(const JsonReader& object) {
    PaintedSurface surface;
    surface.codes = givenIn(object);
    for (const JsonReader& triangle : object.at("triangles").list("a list of triangles")) {
        const auto corners =
            triangle.numbers(9, farthestCorner, "nine numbers: x, y, z of three corners");
        if (!corners)
            break;
        std::ranges::copy(*corners, surface.triangles.emplace_back().begin());
    }
    object.refuseUnknown();
    return surface;
}

void writeCodes(json& object, const GivenCodes& codes) {
    if (codes.temperature)
        object["temperatureIndex"] = *codes.temperature;
    if (codes.material)
        object["materialIndex"] = *codes.material;
}

} // namespace

const std::vector<std::string>& codeRuleNames() {
    static const std::vector<std::string> names = {"material", "object", "group"};
    return names;
}

bool fitsPattern(const std::string& name, const std::string& pattern) {
    // Where a text does not fit after a *, the * takes one byte more.
    std::size_t n = 0, p = 0, star = std::string::npos, after = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            after = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++p, ++n;
        } else if (star != std::string::npos) {
            p = star + 1;
            n = ++after;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string::npos;
}

std::filesystem::path codesFileOf(const std::filesystem::path& model) {
    std::filesystem::path file = model;
    return file.replace_extension(".codes.json");
}

ModelCodes modelCodesFromJson(const std::string& text, const std::string& fileName) {
    const JsonForm form{.expected = "codes of a model (JSON in UTF-8)", .deepest = 8};
    const JsonReader root(text, fileName, form, JsonErrors::collect);
    readJsonHead(root, formatName, newestVersion);
    ModelCodes codes;
    for (const JsonReader& rule : root.at("rules").listOrNone())
        codes.rules.push_back(ruleOf(rule));
    for (const JsonReader& surface : root.at("painted").listOrNone())
        codes.painted.push_back(surfaceOf(surface));
    root.refuseUnknown();
    root.throwRefused();
    return codes;
}

std::string modelCodesToJson(const ModelCodes& codes) {
    json root = {{"format", formatName}, {"version", newestVersion}};
    for (const CodeRule& rule : codes.rules) {
        json one = {{codeRuleNames()[static_cast<std::size_t>(rule.of)], rule.pattern}};
        writeCodes(one, rule.codes);
        root["rules"].push_back(std::move(one));
    }
    for (const PaintedSurface& surface : codes.painted) {
        json one = {{"triangles", surface.triangles}};
        writeCodes(one, surface.codes);
        root["painted"].push_back(std::move(one));
    }
    // A line for a rule and one for a triangle: to be read, compared and merged by lines.
    std::ostringstream text;
    text << "{\n  \"format\": \"" << formatName << "\",\n  \"version\": " << newestVersion
         << ",\n  \"program\": \"" << programWithVersion() << "\"";
    const auto list = [&](const char* key, const auto& each) {
        if (!root.contains(key))
            return;
        text << ",\n  \"" << key << "\": [";
        const char* separator = "\n";
        for (const json& one : root[key]) {
            text << separator << "    ";
            each(one);
            separator = ",\n";
        }
        text << "\n  ]";
    };
    list("rules", [&](const json& rule) { text << textOf(rule); });
    list("painted", [&](const json& surface) {
        json head = surface;
        head.erase("triangles");
        std::string begin = textOf(head);
        begin.back() = ',';
        text << begin << "\"triangles\":[";
        const char* separator = "\n      ";
        for (const json& triangle : surface["triangles"]) {
            text << separator << triangle.dump();
            separator = ",\n      ";
        }
        text << "]}";
    });
    text << "\n}\n";
    return text.str();
}

ModelCodes readModelCodes(const std::filesystem::path& model) {
    const auto file = codesFileOf(model);
    if (!stampOf(file))
        return {};
    return modelCodesFromJson(readFile(file), file.string());
}

void saveModelCodes(const ModelCodes& codes, const std::filesystem::path& model) {
    const auto file = codesFileOf(model);
    allowChange(file);
    if (!codes.empty())
        return writeFileDurably(file, modelCodesToJson(codes));
    std::error_code failure;
    std::filesystem::remove(file, failure);
    if (failure)
        throw InputError({file.string(), "",
                          "a file that cannot be removed (" + failure.message() + ")",
                          "a folder that can be written"});
}

ModelStamp modelStampOf(const std::filesystem::path& model) {
    return {stampOf(model), stampOf(codesFileOf(model))};
}

} // namespace irsg
