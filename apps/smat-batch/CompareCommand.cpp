#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"
#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/image/ComparisonFigures.h"
#include "irsg/image/ImageFile.h"
#include "irsg/image/ImageFormat.h"
#include "smatcore/data/Provenance.h"

namespace smat::batch {

namespace {

using nlohmann::ordered_json;

/// The line as it was given.
struct CompareOptions {
    explicit CompareOptions(CLI::App& command) : numbers(command) {}

    std::string fileA, fileB, channel, channelA, channelB;
    std::string part, partA, partB;
    std::optional<int> page, pageA, pageB;
    std::vector<std::string> rectangles, out;

    irsg::ImageReading readingA() const {
        return {partA.empty() ? part : partA, pageA ? pageA : page};
    }
    irsg::ImageReading readingB() const {
        return {partB.empty() ? part : partB, pageB ? pageB : page};
    }
    NumberOptions numbers;
};

void addNumbers(NumberOptions& numbers) {
    for (const std::string level : {"fail", "warn"}) {
        const std::string twin = level == "fail" ? "failure" : "warning";
        numbers.add("--" + level, "unit", "|A - B| above which a pixel is a " + twin + ", 1e-6");
        numbers.add("--" + level + "-relative", "",
                    "and |A - B| / ((|A| + |B|) / 2) above which it is one, 0");
        numbers.add("--" + level + "-percent", "%", "Let this part of the pixels pass, 0");
        numbers.add("--hard-" + level, "unit", "A single |A - B| above this is a " + twin);
        numbers.add("--allow-" + twin + "s", "px", "Let this many pixels pass, 0");
    }
}

irsg::ComparisonLevel levelOf(const NumberOptions& numbers, const std::string& level) {
    irsg::ComparisonLevel result;
    result.absolute = numbers.value("--" + level).value_or(result.absolute);
    result.relative = numbers.value("--" + level + "-relative").value_or(result.relative);
    result.percent = numbers.value("--" + level + "-percent").value_or(result.percent);
    result.hard = numbers.value("--hard-" + level).value_or(result.hard);
    numbers.takeWhole(level == "fail" ? "--allow-failures" : "--allow-warnings", result.allowed,
                      0.0, 1e15);
    return result;
}

irsg::PixelRectangle rectangleFrom(const std::string& text) {
    irsg::PixelRectangle r;
    int* const parts[] = {&r.x, &r.y, &r.width, &r.height};
    const char* next = text.data();
    const char* const end = text.data() + text.size();
    bool good = true;
    for (int i = 0; i < 4 && good; ++i) {
        const auto read = std::from_chars(next, end, *parts[i]);
        next = read.ptr;
        good = read.ec == std::errc() && (i == 3 ? next == end : next != end && *next == ',');
        next += i < 3 && good ? 1 : 0;
    }
    if (!good)
        throw irsg::InputError({"", "--rectangle", text, "x,y,width,height in whole pixels"});
    return r;
}

void checkOut(const std::vector<std::string>& out) {
    for (const std::string& file : out) {
        if (irsg::imageFormatOf(file) == nullptr) {
            throw irsg::InputError(
                {"", "--out", file, "a name that ends in " + irsg::imageExtensionNames()});
        }
    }
}

void writeDifference(const irsg::RadianceImage& image, const std::filesystem::path& file) {
    irsg::ImageWriting how;
    how.view.colorMap = "diverging";
    how.view.label = "A - B";
    irsg::writeImageFile(image, file, how);
}

std::string rectangleText(const irsg::PixelRectangle& r) {
    return fmt::format("{} x {} px at ({}, {})", r.width, r.height, r.x, r.y);
}

void print(const irsg::Comparison& comparison, const irsg::ComparisonOptions& options) {
    if (options.rectangle)
        fmt::print("rectangle {}\n", rectangleText(*options.rectangle));
    if (!comparison.quantity.empty() && comparison.quantity != "radiance")
        fmt::print("{}, channel {}\n", comparison.quantity,
                   comparison.channelA == comparison.channelB
                       ? comparison.channelA
                       : comparison.channelA + " and " + comparison.channelB);
    const auto figures = irsg::comparisonFigures(comparison, options);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const auto& figure = figures[i];
        if (figure.label.empty())
            continue; // the percent beside a number of pixels, on its line
        std::string text = irsg::shortNumber(figure.value);
        text += figure.unit.empty() ? "" : " " + figure.unit;
        if (i + 1 < figures.size() && figures[i + 1].label.empty())
            text += fmt::format(" ({} %)", irsg::shortNumber(figures[i + 1].value));
        fmt::print("  {:<31} {}{}\n", figure.label, text,
                   figure.detail.empty() ? "" : ", " + figure.detail);
    }
    fmt::print("{}\n", irsg::verdictWord(comparison.verdict));
}

/// Infinity and NaN, which JSON has no numbers for, as the words "inf" and "nan".
ordered_json numberJson(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(irsg::numberText(value));
}

ordered_json pairJson(const irsg::PixelPair& pair) {
    if (pair.x < 0)
        return nullptr;
    return {{"x", pair.x}, {"y", pair.y}, {"a", numberJson(pair.a)}, {"b", numberJson(pair.b)}};
}

ordered_json comparisonJson(const irsg::Comparison& comparison,
                            const irsg::ComparisonOptions& options) {
    ordered_json json = {
        {"verdict", irsg::verdictWord(comparison.verdict)},
        {"rectangle",
         {comparison.area.x, comparison.area.y, comparison.area.width, comparison.area.height}},
        {"channel_a", comparison.channelA},
        {"channel_b", comparison.channelB},
        {"quantity", comparison.quantity},
        {"unit", comparison.unit}};
    for (const auto& figure : irsg::comparisonFigures(comparison, options))
        json[figure.key] = numberJson(figure.value);
    json["total_unit"] = comparison.totalUnit;
    json["peak"] = numberJson(comparison.peak);
    json["epsilon"] = numberJson(comparison.epsilon);
    json["max_error_at"] = pairJson(comparison.largest);
    json["max_relative_error_at"] = pairJson(comparison.largestRelative);
    json["first_nan_a"] = pairJson(comparison.nonFiniteA.firstNan);
    json["first_nan_b"] = pairJson(comparison.nonFiniteB.firstNan);
    json["first_infinite_a"] = pairJson(comparison.nonFiniteA.firstInfinite);
    json["first_infinite_b"] = pairJson(comparison.nonFiniteB.firstInfinite);
    json["warnings"] = comparison.warnings;
    return json;
}

int compare(const CompareOptions& options, Context& context) {
    // Everything that can be wrong with the line, before a file is read.
    options.numbers.check();
    checkOut(options.out);
    irsg::ComparisonOptions compared;
    compared.fail = levelOf(options.numbers, "fail");
    compared.warn = levelOf(options.numbers, "warn");
    compared.channel = options.channel;
    compared.channelA = options.channelA;
    compared.channelB = options.channelB;
    compared.nameA = options.fileA;
    compared.nameB = options.fileB;
    compared.check();
    std::vector<std::optional<irsg::PixelRectangle>> parts;
    for (const std::string& text : options.rectangles)
        parts.push_back(rectangleFrom(text));
    if (parts.empty())
        parts.push_back(std::nullopt);

    // A part or page that is asked of both is one of the file that has any.
    const auto read = [&context](const std::string& file, irsg::ImageReading what, bool isOwn) {
        const StageTimer::Scope scope(&context.timer, "read");
        if (!isOwn && !what.isEmpty() && irsg::imageParts(file).empty())
            what = {};
        return irsg::readImageFile(file, what);
    };
    const bool isOwnA = !options.partA.empty() || options.pageA;
    const bool isOwnB = !options.partB.empty() || options.pageB;
    if (!isOwnA && !isOwnB && !options.readingA().isEmpty() &&
        irsg::imageParts(options.fileA).empty() && irsg::imageParts(options.fileB).empty())
        throw irsg::InputError({"", options.part.empty() ? "--page" : "--part",
                                options.part.empty() ? std::to_string(*options.page) : options.part,
                                "images of which one has several parts or pages"});
    const irsg::RadianceImage a = read(options.fileA, options.readingA(), isOwnA),
                              b = read(options.fileB, options.readingB(), isOwnB);

    irsg::Verdict worst = irsg::Verdict::pass;
    ordered_json results = ordered_json::array();
    for (const auto& part : parts) {
        const StageTimer::Scope scope(&context.timer, "compare");
        compared.rectangle = part;
        const irsg::Comparison comparison = irsg::compareImages(a, b, compared);
        worst = std::max(worst, comparison.verdict);
        if (part == parts.front())
            for (const std::string& sentence : comparison.warnings)
                warn(sentence);
        if (context.json)
            results.push_back(comparisonJson(comparison, compared));
        else
            print(comparison, compared);
    }

    if (!options.out.empty()) {
        // The picture is of the whole, whatever part is judged.
        const StageTimer::Scope scope(&context.timer, "write");
        compared.rectangle.reset();
        auto image = irsg::differenceImage(a, b, irsg::compareImages(a, b, compared), compared);
        image.attributes["program"] = irsg::programWithVersion();
        for (const std::string& file : options.out)
            writeDifference(image, file);
    }
    if (context.json) {
        fmt::print("{}\n", jsonText(ordered_json{{"a", options.fileA},
                                                 {"b", options.fileB},
                                                 {"verdict", irsg::verdictWord(worst)},
                                                 {"comparisons", results}}));
    }
    return worst == irsg::Verdict::pass ? done : worst == irsg::Verdict::warning ? warned : refused;
}

/// "OpenEXR (.exr), CSV (.csv .txt .dat; a plain matrix as well)", of all that can be read.
std::string readableFormats() {
    std::string text;
    for (const irsg::ImageFormat* format : irsg::imageFormats()) {
        if (format->read == nullptr)
            continue;
        const std::string also =
            *format->alsoRead == '\0' ? "" : " " + std::string(format->alsoRead);
        text +=
            fmt::format("{}{} ({}{}{})", text.empty() ? "" : ", ", format->shortName,
                        format->extensions, also, format->isText ? "; a plain matrix as well" : "");
    }
    return text;
}

} // namespace

void addCompareCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand(
        "compare", "Compares two images: exit code 0 pass, 1 warning, 2 failure or refused");
    auto options = std::make_shared<CompareOptions>(*command);
    command->add_option("A", options->fileA, "Image: " + readableFormats())
        ->required()
        ->type_name("");
    command->add_option("B", options->fileB, "The reference, of the same size")
        ->required()
        ->type_name("");
    addNumbers(options->numbers);
    const auto addChoices = [&](const std::string& side, const std::string& of,
                                std::string& channel, std::string& part, std::optional<int>& page,
                                const char* remark) {
        command->add_option("--channel" + side, channel, "Channel of " + of + remark)
            ->type_name("NAME");
        command
            ->add_option("--part" + side, part,
                         "Part of " + of +
                             ", where an OpenEXR file has several: its name or number")
            ->type_name("NAME");
        command
            ->add_option("--page" + side, page,
                         "Page of " + of + ", where a TIFF file has several: its number from 1")
            ->check(CLI::Range(1, 1000))
            ->type_name("N");
    };
    addChoices("", "both", options->channel, options->part, options->page,
               "; without it the only one, else the one that is shown in place of radiance, else "
               "L, else Y. Images of different quantities are refused without it. An image that "
               "does not have it takes "
               "part with its usual one");
    addChoices("-a", "A alone", options->channelA, options->partA, options->pageA, "");
    addChoices("-b", "B alone", options->channelB, options->partB, options->pageB, "");
    command
        ->add_option("--rectangle", options->rectangles,
                     "Compares this part alone; given again, each on its own")
        ->type_name("X,Y,W,H")
        ->expected(1)
        ->take_all();
    command
        ->add_option("--out", options->out,
                     "The difference A - B as .exr or .csv, or a picture of it as .png; may be "
                     "given again")
        ->type_name("FILE")
        ->expected(1)
        ->take_all();
    command->callback([&context, options] {
        context.work = [&context, options] { return compare(*options, context); };
    });
}

} // namespace smat::batch
