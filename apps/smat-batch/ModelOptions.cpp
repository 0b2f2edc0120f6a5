#include "apps/smat-batch/ModelOptions.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "apps/smat-batch/Command.h"
#include "irsg/core/Collect.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"

namespace smat::batch {

namespace {

/// "none" is no entry.
std::optional<int> entryOf(const char* option, const std::string& text) {
    if (text == "none")
        return std::nullopt;
    const auto number = irsg::parseNumber(text);
    if (!number || *number != std::floor(*number) || std::abs(*number) > 2147483647.0)
        throw refusal(option, text, "the index of an entry, a whole number, or none");
    return static_cast<int>(*number);
}

irsg::Vec3 pointOf(const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto number = irsg::parseNumber(text.substr(begin, end - begin));
        if (!number || std::abs(*number) > 1e9)
            break;
        numbers.push_back(*number);
        begin = end + 1;
    }
    if (numbers.size() != 3 || std::ranges::count(text, ',') != 2)
        throw refusal("--reference-point", text, "x,y,z in m, each up to 1e9, or centre");
    return {numbers[0], numbers[1], numbers[2]};
}

} // namespace

ModelOptions::ModelOptions(CLI::App& command) : placing_(command) {
    command.add_option("--name", name_, "What results call it; that of the file without it")
        ->type_name("NAME");
    databaseOption_ =
        command
            .add_option("--database", database_,
                        "Its signature database (.sigdb); the one that lies beside a new model "
                        "without it")
            ->type_name("FILE");
    command
        .add_option("--fallback-temperature", fallbackTemperature_,
                    "Entry that stands in for temperature codes without one, or none")
        ->type_name("INDEX");
    command
        .add_option("--fallback-material", fallbackMaterial_,
                    "Entry that stands in for material codes without one, or none")
        ->type_name("INDEX");
    command
        .add_option("--reference-point", referencePoint_,
                    "Point that cameras turn about and ranges are counted from, x,y,z in model "
                    "axes (m), or centre")
        ->type_name("POINT");
    for (const ModelField& field : modelFields()) {
        auto given = std::make_unique<Given>(Given{&field, {}});
        command
            .add_option(field.info.option, given->text,
                        field.info.help + " (" + field.info.expected() + "; " +
                            field.info.defaultText + ")")
            ->type_name(field.info.unit)
            ->group("Place and state");
        fields_.push_back(std::move(given));
    }
}

bool ModelOptions::areGiven() const {
    return !name_.empty() || databaseOption_->count() > 0 || !referencePoint_.empty() ||
           !placing_.given().empty() || !fallbackTemperature_.empty() ||
           !fallbackMaterial_.empty() ||
           std::ranges::any_of(fields_, [](const auto& given) { return !given->text.empty(); });
}

void ModelOptions::apply(Project& project, std::size_t model) const {
    std::vector<irsg::Diagnostic> diagnostics;
    const auto collect = [&](const auto& work) { irsg::collect(diagnostics, work); };
    ProjectModel& one = project.models.at(model);
    if (!name_.empty())
        one.name = name_;
    if (databaseOption_->count() > 0)
        one.database = database_.empty() ? std::filesystem::path()
                                         : std::filesystem::absolute(database_).lexically_normal();
    collect([&] { one.options = placing_.over(one.options); });
    if (!referencePoint_.empty())
        collect([&] {
            one.referencePoint_m = referencePoint_ == "centre"
                                       ? std::nullopt
                                       : std::optional(pointOf(referencePoint_));
        });
    if (!fallbackTemperature_.empty())
        collect([&] {
            one.fallbackTemperature = entryOf("--fallback-temperature", fallbackTemperature_);
        });
    if (!fallbackMaterial_.empty())
        collect([&] { one.fallbackMaterial = entryOf("--fallback-material", fallbackMaterial_); });
    const auto isGiven = [&](const char* key) {
        return std::ranges::any_of(fields_, [&](const auto& given) {
            return given->field->key == key && !given->text.empty();
        });
    };
    if (isGiven("heading") && isGiven("yaw"))
        diagnostics.push_back({"--yaw", "", "beside --heading", "one of the two: they are one"});
    for (const auto& given : fields_)
        if (!given->text.empty())
            collect([&] {
                setField(project, model, *given->field, given->text, given->field->info.option);
            });
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
}

} // namespace smat::batch
