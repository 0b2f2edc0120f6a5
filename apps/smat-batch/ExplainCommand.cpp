#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/ExplainOutput.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/ProjectInput.h"
#include "apps/smat-batch/SettingOptions.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::batch {

namespace {

constexpr const char* pixelOption = "--pixel";

/// "x,y", counted from the top left pixel, which is 0,0.
std::pair<int, int> pixelOf(const std::string& text) {
    const auto refuse = [&] {
        return refusal(pixelOption, text, "column and row of a pixel, such as 12,34");
    };
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
        throw refuse();
    const auto number = [&](std::size_t first, std::size_t last) {
        int value = 0;
        const char* end = text.data() + last;
        const auto [stop, error] = std::from_chars(text.data() + first, end, value);
        if (error != std::errc{} || stop != end)
            throw refuse();
        return value;
    };
    const int x = number(0, comma);
    return {x, number(comma + 1, text.size())};
}

/// `smat-batch explain PROJECT --pixel x,y [options of image]`.
class ExplainCommand {
  public:
    explicit ExplainCommand(CLI::App& command)
        : project_(command), settings_(command, AnalysisKind::image) {
        command
            .add_option(pixelOption, pixels_,
                        "Column and row; 0,0 is the top left pixel; may be given more than once")
            ->type_name("x,y")
            ->expected(1)
            ->take_all()
            ->required();
        command.add_option("--analysis", analysis_, "Start from this image of the project")
            ->type_name("NAME");
        command.footer(
            "Draws the image that `image` gives and traces rays through the same samples of the "
            "pixel. Facets are met and terms are summed in double precision on the processor; the "
            "factors of each sample (cosines) are kept as float. Asks for a build with Embree. A "
            "picture of one band, as radiance whatever --quantity says.");
    }

    int run(Context& context) const {
        AnalysisData data;
        std::vector<std::pair<int, int>> pixels;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            for (const std::string& text : pixels_)
                pixels.push_back(pixelOf(text));
            data = started(project_.load());
        }
        SceneBuilder builder;
        const SceneDescription scene = builder.build(data.project, data.settings);
        check(pixels, scene);

        const std::unique_ptr<ImageSource> source = makeIrsgImageSource();
        AnalysisGenerator(*source, [&](const Project&, const Settings&) {
            return scene;
        }).run(data, {}, {}, &context.timer);
        for (const std::string& warning : data.warnings)
            warn(data.name + ": " + warning);

        const StageTimer::Scope scope(&context.timer, "explain");
        const auto explain = [&] {
            const StageTimer::Scope ready(&context.timer, "make ready to explain");
            return source->explainer();
        }();
        std::vector<ExplainedPixel> explained;
        for (const auto& [x, y] : pixels)
            explained.push_back({explain(x, y), static_cast<double>(data.image.at(x, y))});
        fmt::print("{}", context.json ? explanationJson(explained, data.renderer)
                                      : explanationText(explained, data.renderer));
        return done;
    }

  private:
    AnalysisData started(const Project& project) const {
        AnalysisData data = analysis_.empty() ? AnalysisData::of(project, AnalysisKind::image)
                                              : AnalysisData::of(project, analysis_);
        if (data.kind->form != AnalysisForm::image)
            throw refusal("--analysis", analysis_ + ", which is of kind " + name(data.kind),
                          "an analysis of kind image");
        data.settings = data.settings.with(settings_.values());
        data.settings.set(key::imageQuantity, "radiance");
        if (bandsOf(data.project, data.settings).size() > 1)
            throw refusal("--band", "several bands", "one band: a pixel has terms for each");
        return data;
    }

    static void check(const std::vector<std::pair<int, int>>& pixels,
                      const SceneDescription& scene) {
        const irsg::Sensor& sensor = scene.sensor;
        for (const auto& [x, y] : pixels)
            if (x < 0 || y < 0 || x >= sensor.width_px || y >= sensor.height_px)
                throw refusal(pixelOption, fmt::format("{},{}", x, y),
                              fmt::format("a pixel of the picture, which has columns 0 to {} and "
                                          "rows 0 to {}",
                                          sensor.width_px - 1, sensor.height_px - 1));
    }

    ProjectInput project_;
    SettingOptions settings_;
    std::vector<std::string> pixels_;
    std::string analysis_;
};

} // namespace

void addExplainCommand(CLI::App& app, Context& context) {
    addCommand<ExplainCommand>(app, context, "explain",
                               "What a pixel of the image is made of, term by term");
}

} // namespace smat::batch
