#include "apps/smat/PlotCommand.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotExport.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "gui/plot/TablePlot.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/support/NearestNames.h"

namespace smat {
namespace {

void refuse(bool given, const char* option, const char* reason) {
    if (given)
        throw irsg::InputError({option, "", "", reason});
}

/// Which of the values of each axis `--at KEY=VALUE` asks for; the first where it says nothing.
SignatureTable::Choice chosen(const SignatureTable& table, const std::vector<std::string>& at) {
    SignatureTable::Choice choice(table.axes().size(), 0);
    for (const std::string& text : at) {
        const std::size_t equals = text.find('=');
        const std::string key = text.substr(0, equals);
        const auto axis = std::ranges::find(table.axes(), key, &SignatureTable::Axis::key);
        std::vector<std::string> keys;
        for (const SignatureTable::Axis& one : table.axes())
            keys.push_back(one.key);
        if (equals == std::string::npos || axis == table.axes().end())
            throw irsg::InputError({"--at", "", text,
                                    keys.empty() ? "nothing: this table has one range and state"
                                                 : "KEY=VALUE with " + oneOf(keys, key)});
        bool isNumber = false;
        const double value = QString::fromStdString(text.substr(equals + 1)).toDouble(&isNumber);
        std::string values;
        std::size_t nearest = axis->values.size();
        for (std::size_t i = 0; i < axis->values.size(); ++i) {
            values += (values.empty() ? "" : ", ") + irsg::numberText(axis->values[i]);
            if (std::abs(axis->values[i] - value) <= 1e-9 * std::abs(axis->values[i]))
                nearest = i;
        }
        if (!isNumber || nearest == axis->values.size())
            throw irsg::InputError({"--at", "", text, "one of " + values});
        choice[static_cast<std::size_t>(axis - table.axes().begin())] = nearest;
    }
    return choice;
}

void plotTable(const PlotRequest& request, ResultTable table) {
    refuse(request.logX, "--log-x", "a table over directions has no abscissa; --db for its values");
    refuse(request.logY, "--log-y", "a table over directions has no ordinate; --db for its values");
    gui::TableDrawing drawing(std::make_shared<const ResultTable>(std::move(table)));
    if (!request.quantity.empty()) {
        if (drawing.table().column(request.quantity) == nullptr) {
            std::vector<std::string> keys;
            for (const ResultColumn* column : drawing.table().columns())
                keys.push_back(column->key);
            throw irsg::InputError({request.results.front().string(), "",
                                    "no column \"" + request.quantity + "\"",
                                    oneOf(keys, request.quantity)});
        }
        drawing.setColumn(request.quantity);
    }
    drawing.setChoice(chosen(drawing.table(), request.at));
    drawing.setDecibel(request.decibel);
    drawing.title = QString::fromStdString(request.results.front().stem().string());
    drawing.conditions = QString::fromStdString(lineOf(conditionsOf(drawing.table().table())));
    gui::exportTable(drawing, request.output);
}

} // namespace

void plot(const PlotRequest& request) {
    std::vector<ResultTable> tables;
    for (const auto& file : request.results)
        tables.push_back(ResultTable::load(file));
    if (tables.size() == 1 && SignatureTable::isOne(tables.front()))
        return plotTable(request, std::move(tables.front()));
    refuse(!request.at.empty(), "--at", "only a signature table alone has ranges and states");
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
    refuse(request.decibel, "--db",
           "only polar plots and signature tables have decibels; --log-y for this one");
    gui::CartesianPlot drawing(gui::PlotStyle::paper());
    auto data = gui::cartesianData(results, quantity);
    data.xLogarithmic = data.xLogarithmic || request.logX;
    data.yLogarithmic = request.logY;
    drawing.setData(std::move(data));
    gui::exportPlot(drawing, request.output);
}

} // namespace smat
