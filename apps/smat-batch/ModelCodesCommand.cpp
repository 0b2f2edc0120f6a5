#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/geometry/model/FirstSignature.h"
#include "irsg/signature/SignatureFile.h"

namespace smat::batch {

namespace {

using irsg::CodeRule;
using irsg::ModelCodes;

constexpr const char* ruleExpected =
    "KIND:PATTERN=TEMPERATURE,MATERIAL: material, object or group; a name with * and ?; indices, "
    "of "
    "which one may be left out (\"material:Paint*=1,2\", \"group:Engine*=4,\")";

struct Options {
    std::string model;
    std::vector<std::string> rules, removed;
    bool clear = false, suggest = false;
    std::string database;
};

std::optional<int> indexOf(const std::string& text, const std::string& rule) {
    if (text.empty())
        return std::nullopt;
    int index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc() || end != text.data() + text.size())
        throw refusal("--rule", rule, ruleExpected);
    return index;
}

/// "material:Paint*", what of a text comes before the indices.
CodeRule nameOf(const char* option, const std::string& text, const std::string& expected) {
    const std::size_t colon = text.find(':');
    const auto& kinds = irsg::codeRuleNames();
    const auto kind = std::ranges::find(kinds, text.substr(0, colon));
    if (colon == text.npos || kind == kinds.end())
        throw refusal(option, text, expected);
    return {.of = static_cast<CodeRule::Of>(kind - kinds.begin()),
            .pattern = text.substr(colon + 1),
            .codes = {}};
}

CodeRule ruleOf(const std::string& text) {
    const std::size_t equals = text.rfind('=');
    const std::size_t comma = equals == text.npos ? text.npos : text.find(',', equals);
    if (comma == text.npos)
        throw refusal("--rule", text, ruleExpected);
    CodeRule rule = nameOf("--rule", text.substr(0, equals), ruleExpected);
    rule.codes.temperature = indexOf(text.substr(equals + 1, comma - equals - 1), text);
    rule.codes.material = indexOf(text.substr(comma + 1), text);
    if (!rule.codes.temperature && !rule.codes.material)
        throw refusal("--rule", text, ruleExpected);
    return rule;
}

bool sameName(const CodeRule& a, const CodeRule& b) {
    return a.of == b.of && a.pattern == b.pattern;
}

/// The codes beside the model with what the options change. A rule for a name that has one replaces
/// it where it stands; others come last, where they win.
ModelCodes changed(const Options& options) {
    ModelCodes codes = options.clear ? ModelCodes() : irsg::readModelCodes(options.model);
    for (const std::string& text : options.removed) {
        const CodeRule name = nameOf("--remove", text, "KIND:PATTERN of a rule that there is");
        if (std::erase_if(codes.rules,
                          [&](const CodeRule& rule) { return sameName(rule, name); }) == 0)
            throw refusal("--remove", text, "KIND:PATTERN of a rule that there is");
    }
    for (const std::string& text : options.rules) {
        const CodeRule rule = ruleOf(text);
        const auto known = std::ranges::find_if(
            codes.rules, [&](const CodeRule& other) { return sameName(rule, other); });
        if (known != codes.rules.end())
            *known = rule;
        else
            codes.rules.push_back(rule);
    }
    return codes;
}

std::string shown(const std::optional<int>& index) {
    return index ? std::to_string(*index) : "-";
}

std::string shown(const std::map<irsg::IrCodes, long>& codes) {
    std::string text;
    for (const auto& [pair, polygons] : codes) {
        if (text.size() > 40)
            return text + " ...";
        text += fmt::format("{}{},{}", text.empty() ? "" : "  ", pair.temperature, pair.material);
    }
    return text;
}

nlohmann::ordered_json jsonOf(const std::string& name, const irsg::NamedFaces& faces) {
    nlohmann::ordered_json codes = nlohmann::ordered_json::array();
    for (const auto& [pair, polygons] : faces.codes)
        codes.push_back({{"temperature", pair.temperature},
                         {"material", pair.material},
                         {"polygons", polygons}});
    return {{"name", name}, {"polygons", faces.polygons}, {"area", faces.area}, {"codes", codes}};
}

/// Codes and entries that the names in the model suggest, in place of what there is.
ModelCodes suggested(const Options& options) {
    if (options.database.empty())
        throw refusal("--suggest", options.model,
                      "--database FILE.sigdb for the entries that it suggests");
    const auto surfaces = irsg::suggestedSurfaces(irsg::namesOf(options.model, ModelCodes()).parts);
    const auto first =
        irsg::firstSignatureOf(surfaces, std::filesystem::path(options.model).stem().string());
    // The database is not made where the codes, which are written last, would not be.
    irsg::checkWritable(irsg::codesFileOf(options.model));
    irsg::createSignatureFile(first.database, options.database);
    return first.codes;
}

int showCodes(const Options& options, Context& context) {
    const bool changes =
        options.suggest || options.clear || !options.rules.empty() || !options.removed.empty();
    if (!options.suggest && !options.database.empty())
        throw refusal("--database", options.database, "--suggest, which makes one");
    if (options.suggest && !(options.rules.empty() && options.removed.empty()))
        throw refusal("--suggest", options.model, "no --rule and no --remove beside it");
    const ModelCodes codes = options.suggest ? suggested(options) : changed(options);
    // The model is looked at first: nothing is written beside what cannot be read.
    const auto [names, parts, remarks] = irsg::namesOf(options.model, codes);
    if (changes)
        irsg::saveModelCodes(codes, options.model);
    const auto file = irsg::codesFileOf(options.model).string();
    if (context.json) {
        nlohmann::ordered_json root{{"file", file}};
        root["rules"] = nlohmann::ordered_json::parse(irsg::modelCodesToJson({codes.rules, {}}))
                            .value("rules", nlohmann::ordered_json::array());
        root["paintedSurfaces"] = codes.painted.size();
        for (std::size_t i = 0; i < names.size(); ++i) {
            auto& list = root["names"][irsg::codeRuleNames()[i]] = nlohmann::ordered_json::array();
            for (const auto& [name, faces] : names[i])
                list.push_back(jsonOf(name, faces));
        }
        root["remarks"] = remarks;
        fmt::print("{}\n", jsonText(root));
        return done;
    }
    fmt::print("{}: {} rules, {} painted surfaces{}\n", file, codes.rules.size(),
               codes.painted.size(), changes ? ", saved" : "");
    for (const CodeRule& rule : codes.rules)
        fmt::print("  {:<8} {:<32} temperature {:>4}  material {:>4}\n",
                   irsg::codeRuleNames()[static_cast<std::size_t>(rule.of)], rule.pattern,
                   shown(rule.codes.temperature), shown(rule.codes.material));
    fmt::print("  {:<8} {:<32} {:>9} {:>12}  {}\n", "kind", "name", "polygons", "area",
               "temperature,material");
    for (std::size_t i = 0; i < names.size(); ++i)
        for (const auto& [name, faces] : names[i])
            fmt::print("  {:<8} {:<32} {:>9} {:>12.6g}  {}\n", irsg::codeRuleNames()[i],
                       name.empty() ? "(no name)" : name, faces.polygons, faces.area,
                       shown(faces.codes));
    for (const std::string& remark : remarks)
        fmt::print("  note: {}\n", remark);
    return done;
}

} // namespace

void addModelCodesCommand(CLI::App& model, Context& context) {
    CLI::App* command = model.add_subcommand(
        "codes",
        "Names in a model and the codes of their faces; with rules, changes what is beside "
        "the model in MODEL.codes.json");
    auto options = std::make_shared<Options>();
    command->add_option("MODEL", options->model, "Model")->required()->type_name("");
    command
        ->add_option("--rule", options->rules,
                     std::string("Gives codes to what carries a name: ") + ruleExpected +
                         "; may be repeated, the last wins")
        ->type_name("RULE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--remove", options->removed, "Takes a rule away: KIND:PATTERN")
        ->type_name("NAME")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_flag(
        "--suggest", options->suggest,
        "Makes rules and a new --database from the names in the model: first choices");
    command->add_option("--database", options->database, "Signature database (.sigdb) to be made")
        ->type_name("FILE");
    command->add_flag("--clear", options->clear,
                      "Begins without the rules and the paint that there are");
    command->callback([&context, options] {
        context.work = [&context, options] { return showCodes(*options, context); };
    });
}

} // namespace smat::batch
