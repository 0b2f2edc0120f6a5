#include "apps/smat/PlotCommand.h"

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotExport.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "irsg/radiometry/Errors.h"

namespace smat {
namespace {

void refuse(bool given, const char* option, const char* reason) {
    if (given)
        throw irsg::InputError({option, "", "", reason});
}

} // namespace

void plot(const PlotRequest& request) {
    std::vector<ResultTable> tables;
    for (const auto& file : request.results)
        tables.push_back(ResultTable::load(file));
    std::vector<gui::NamedResult> results;
    for (std::size_t i = 0; i < tables.size(); ++i)
        results.push_back({QString::fromStdString(request.results[i].stem().string()), &tables[i]});

    const std::string quantity = request.quantity.empty()
                                     ? gui::plottableQuantities(tables.front()).front()
                                     : request.quantity;
    if (gui::isPolar(tables.front())) {
        refuse(request.logX, "--log-x", "an angle has no logarithmic axis; --db for the radius");
        refuse(request.logY, "--log-y", "the radius of a polar plot takes --db");
        gui::PolarPlot drawing(gui::PlotStyle::paper());
        drawing.setData(gui::polarData(results, quantity));
        if (request.decibel)
            drawing.setRadiusScale(gui::RadiusScale::decibel);
        gui::exportPlot(drawing, request.output);
        return;
    }
    refuse(request.decibel, "--db", "only polar plots have a decibel radius; --log-y for this one");
    gui::CartesianPlot drawing(gui::PlotStyle::paper());
    auto data = gui::cartesianData(results, quantity);
    data.xLogarithmic = data.xLogarithmic || request.logX;
    data.yLogarithmic = request.logY;
    drawing.setData(std::move(data));
    gui::exportPlot(drawing, request.output);
}

} // namespace smat
