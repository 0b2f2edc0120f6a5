#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/ProjectInput.h"
#include "apps/smat-batch/SettingOptions.h"
#include "irsg/core/Wording.h"
#include "irsg/image/ImageFile.h"
#include "irsg/image/ImageFormat.h"
#include "smatcore/analysis/AnalysisOfResult.h"
#include "smatcore/analysis/PixelExplainer.h"
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

/// Of the images that say how they were computed.
std::vector<std::string> extensionsThatKeepValues() {
    std::vector<std::string> extensions;
    for (const irsg::ImageFormat* format : irsg::imageFormats())
        if (format->read != nullptr)
            extensions.push_back(format->extensionList().front());
    return extensions;
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
            "PROJECT may be an image (" + irsg::alternatives(extensionsThatKeepValues()) +
            ") that this program computed of a project beside it. Draws the image that `image` "
            "gives and traces rays through the same samples of the "
            "pixel. Facets are met and terms are summed in double precision on the processor; the "
            "factors of each sample (cosines) are kept as float. Asks for a build with Embree. A "
            "picture of one band, as radiance whatever --quantity says.");
    }

    int run(Context& context) {
        AnalysisData data;
        std::vector<std::pair<int, int>> pixels;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            for (const std::string& text : pixels_)
                pixels.push_back(pixelOf(text));
            data = started();
        }
        check(pixels, data.settings);
        PixelExplainer explainer(std::move(data), {}, {}, &context.timer);
        for (const std::string& warning : explainer.drawn().warnings)
            warn(explainer.drawn().name + ": " + warning);

        const StageTimer::Scope scope(&context.timer, "explain");
        std::vector<ExplainedPixel> explained;
        for (const auto& [x, y] : pixels)
            explained.push_back(explainer.explain(x, y));
        if (image_ && image_->primary().name == "L")
            for (std::size_t i = 0; i < pixels.size(); ++i)
                explained[i].inImage_W_m2_sr =
                    static_cast<double>(image_->at(pixels[i].first, pixels[i].second));
        fmt::print("{}", context.json ? explanationJson(explained, explainer.drawn().renderer)
                                      : explanationText(explained, explainer.drawn().renderer));
        return done;
    }

  private:
    AnalysisData started() {
        AnalysisData data;
        if (irsg::readableImageFormatOf(project_.file()) != nullptr) {
            if (!analysis_.empty() || !settings_.values().values().empty())
                throw refusal(analysis_.empty() ? "--set" : "--analysis", "an option",
                              "none: an image says how it was computed");
            image_ = irsg::readImageFile(project_.file());
            std::vector<std::string> remarks;
            data = analysisOfImage(*image_, project_.file(), {}, &remarks);
            for (const std::string& remark : remarks)
                warn(remark);
            return data;
        }
        Project project = project_.load();
        settings_.place(project);
        data = analysis_.empty() ? AnalysisData::of(project, AnalysisKind::image)
                                 : AnalysisData::of(project, analysis_);
        if (data.kind->form != AnalysisForm::image)
            throw refusal("--analysis", analysis_ + ", which is of kind " + name(data.kind),
                          "an analysis of kind image");
        data.settings = data.settings.with(settings_.values());
        settings_.requireNamed(data.settings);
        return data;
    }

    static void check(const std::vector<std::pair<int, int>>& pixels, const Settings& settings) {
        const int width = settings[key::sensorWidth], height = settings[key::sensorHeight];
        for (const auto& [x, y] : pixels)
            if (x < 0 || y < 0 || x >= width || y >= height)
                throw refusal(pixelOption, fmt::format("{},{}", x, y),
                              fmt::format("a pixel of the picture, which has columns 0 to {} and "
                                          "rows 0 to {}",
                                          width - 1, height - 1));
    }

    ProjectInput project_;
    SettingOptions settings_;
    std::vector<std::string> pixels_;
    std::string analysis_;
    std::optional<irsg::RadianceImage> image_; ///< that is asked about
};

} // namespace

void addExplainCommand(CLI::App& app, Context& context) {
    addCommand<ExplainCommand>(app, context, "explain",
                               "What a pixel of the image is made of, term by term");
}

} // namespace smat::batch
