#include "irsg/geometry/model/ModelCodes.h"

#include <cmath>
#include <sstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/JsonText.h"
#include "irsg/signature/JsonReader.h"

namespace irsg {
namespace {

using nlohmann::json;

constexpr const char* formatName = "smat-codes";
constexpr int newestVersion = 1;
constexpr double farthest = 1e9;

std::optional<int> indexOf(JsonObject& object, const char* key, JsonProblems& problems) {
    const json* const value = object.find(key);
    if (value == nullptr)
        return std::nullopt;
    if (value->is_number_integer() && std::abs(value->get<double>()) <= 2147483647.0)
        return value->get<int>();
    problems.add(object.pathOf(key), *value, "the index of an entry, a whole number");
    return std::nullopt;
}

GivenCodes givenIn(JsonObject& object, JsonProblems& problems) {
    const GivenCodes codes{indexOf(object, "temperatureIndex", problems),
                           indexOf(object, "materialIndex", problems)};
    if (!object.find("temperatureIndex") && !object.find("materialIndex"))
        problems.addText(object.path(), "no index", "temperatureIndex, materialIndex or both");
    return codes;
}

CodeRule ruleOf(const json& value, const std::string& path, JsonProblems& problems) {
    JsonObject object(value, path, problems);
    CodeRule rule;
    int found = 0;
    for (std::size_t i = 0; i < codeRuleNames().size(); ++i)
        if (object.find(codeRuleNames()[i]) != nullptr) {
            rule.of = static_cast<CodeRule::Of>(i);
            rule.pattern = object.text(codeRuleNames()[i], true);
            ++found;
        }
    if (found != 1 && value.is_object())
        problems.addText(path, found == 0 ? "a rule for nothing" : "a rule for several",
                         "one of material, object and group");
    rule.codes = givenIn(object, problems);
    object.finish();
    return rule;
}

PaintedSurface surfaceOf(const json& value, const std::string& path, JsonProblems& problems) {
    JsonObject object(value, path, problems);
    PaintedSurface surface;
    surface.codes = givenIn(object, problems);
    if (const json* const triangles = object.find("triangles", true)) {
        if (!triangles->is_array())
            problems.add(object.pathOf("triangles"), *triangles, "a list of triangles");
        else
            for (std::size_t i = 0; i < triangles->size(); ++i) {
                const json& triangle = (*triangles)[i];
                bool isRight = triangle.is_array() && triangle.size() == 9;
                std::array<double, 9> corners{};
                for (std::size_t k = 0; isRight && k < 9; ++k) {
                    isRight =
                        triangle[k].is_number() && std::abs(triangle[k].get<double>()) <= farthest;
                    if (isRight)
                        corners[k] = triangle[k].get<double>();
                }
                if (!isRight) {
                    problems.add(object.pathOf("triangles") + "." + std::to_string(i), triangle,
                                 "nine numbers: x, y, z of three corners");
                    break;
                }
                surface.triangles.push_back(corners);
            }
    }
    object.finish();
    return surface;
}

template <typename Value, typename Read>
void readList(JsonObject& root, const char* key, std::vector<Value>& values, JsonProblems& problems,
              const Read& read) {
    const json* const list = root.find(key);
    if (list == nullptr)
        return;
    if (!list->is_array())
        return problems.add(key, *list, "a list");
    for (std::size_t i = 0; i < list->size(); ++i)
        values.push_back(read((*list)[i], std::string(key) + "." + std::to_string(i), problems));
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
    const json root = parseJson(text, fileName, form);
    JsonProblems problems(fileName, text);
    ModelCodes codes;
    JsonObject object(root, "", problems);
    const std::string format = object.text("format", true);
    if (format != formatName && !format.empty())
        problems.addText("format", "'" + format + "'", formatName);
    const double version = object.number("version", newestVersion, true);
    if (version != newestVersion)
        problems.addText("version", shownJson(root["version"]), "1");
    problems.throwIfAny();
    readList(object, "rules", codes.rules, problems, ruleOf);
    readList(object, "painted", codes.painted, problems, surfaceOf);
    object.finish();
    problems.throwIfAny();
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
    text << "{\n  \"format\": \"" << formatName << "\",\n  \"version\": " << newestVersion;
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
    list("rules", [&](const json& rule) { text << rule.dump(); });
    list("painted", [&](const json& surface) {
        json head = surface;
        head.erase("triangles");
        std::string begin = head.dump();
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
