#include "gui/plot/ResultPlot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "irsg/radiometry/Errors.h"
#include "smatcore/data/ResultDifference.h"

namespace smat::gui {
namespace {

/// What a reader asks for first.
constexpr std::array favourites{"contrast_intensity", "spectral_contrast_intensity",
                                "difference_contrast_intensity",
                                "difference_spectral_contrast_intensity"};

const ResultColumn& abscissaOf(const ResultTable& table) {
    return *table.find(abscissaKey(table));
}

void requireRows(const ResultTable& table, const std::string& name) {
    if (table.empty())
        throw irsg::InputError({name, "", "a table without rows", "at least one row to draw"});
}

Curve curveOf(const NamedResult& result, const std::string& quantity) {
    requireRows(*result.table, result.name.toStdString());
    const auto* column = result.table->find(quantity);
    if (column == nullptr) {
        std::string keys;
        for (const auto& key : plottableQuantities(*result.table))
            keys += (keys.empty() ? "" : ", ") + key;
        throw irsg::InputError(
            {result.name.toStdString(), "", "no column \"" + quantity + "\"", "one of " + keys});
    }
    Curve curve{result.name, abscissaOf(*result.table).values, column->values};
    if (const auto* error = result.table->find("error_" + quantity))
        curve.error = error->values;
    return curve;
}

void requireSame(const std::vector<NamedResult>& results, const std::string& what,
                 const std::function<std::string(const ResultTable&)>& property) {
    if (results.empty())
        throw irsg::LogicError("a plot needs at least one result");
    const std::string wanted = property(*results.front().table);
    for (const auto& result : results) {
        const std::string found = property(*result.table);
        if (found != wanted)
            throw irsg::InputError({result.name.toStdString(), "", what + " " + found,
                                    wanted + ", as in " + results.front().name.toStdString()});
    }
}

QString titleOf(const std::vector<NamedResult>& results, const ResultColumn& column,
                const QString& over) {
    QString label = QString::fromStdString(column.axisTitle());
    label = label.left(label.indexOf(" ("));
    QString title = label + " over " + over;
    if (results.size() == 1 && !results[0].name.isEmpty())
        title += QStringLiteral(" – ") + results[0].name;
    return title;
}

QString plainLabel(const ResultColumn& column) {
    const QString title = QString::fromStdString(column.axisTitle());
    return title.left(title.indexOf(" (")).toLower();
}

/// The elevation of a camera-azimuth sweep, the same in all its rows.
double offset_deg(const ResultTable& table) {
    const auto* elevation = table.find(irsg::Quantity::elevation);
    return elevation == nullptr || elevation->values.empty() ? 0.0 : elevation->values.front();
}

} // namespace

bool isPolar(const ResultTable& table) {
    return !table.columns().empty() && table.columns().front().key == "angle";
}

std::vector<std::string> plottableQuantities(const ResultTable& table) {
    requireRows(table, "result");
    std::vector<std::string> keys;
    for (const auto& column : table.columns()) {
        const bool error = column.key.rfind("error_", 0) == 0;
        if (!isAbscissa(table, column) && !error)
            keys.push_back(column.key);
    }
    if (keys.empty())
        throw irsg::InputError({"result", "header", "no column that was measured",
                                "a column such as contrast_intensity [W sr-1]"});
    const auto wanted = [](const std::string& key) {
        return std::find(favourites.begin(), favourites.end(), key) != favourites.end();
    };
    std::stable_partition(keys.begin(), keys.end(), wanted);
    return keys;
}

bool goOnOnePlot(const ResultTable& a, const ResultTable& b) {
    if (a.empty() || b.empty() || isPolar(a) != isPolar(b))
        return false;
    const bool sameAxis = isPolar(a) ? polarTypeOf(a) == polarTypeOf(b)
                                     : abscissaOf(a).header() == abscissaOf(b).header();
    try {
        return sameAxis && b.find(plottableQuantities(a).front()) != nullptr;
    } catch (const irsg::InputError&) {
        return false; // nothing in it can be drawn
    }
}

PlotData cartesianData(const std::vector<NamedResult>& results, const std::string& quantity) {
    requireSame(results, "abscissa",
                [](const ResultTable& t) { return t.empty() ? "none" : abscissaOf(t).header(); });
    PlotData data;
    for (const auto& result : results)
        data.curves.push_back(curveOf(result, quantity));

    const auto& first = *results.front().table;
    const auto& x = abscissaOf(first);
    const auto& y = *first.find(quantity);
    data.title = titleOf(results, y, plainLabel(x));
    data.xTitle = QString::fromStdString(x.axisTitle());
    data.yTitle = QString::fromStdString(y.axisTitle());

    // Ranges that were spaced by equal ratios are read on a logarithmic axis.
    data.xLogarithmic = first.provenance.value("range.log") == "true";
    return data;
}

PolarData polarData(const std::vector<NamedResult>& results, const std::string& quantity) {
    requireSame(results, "a polar plot of type", polarTypeOf);
    PolarData data;
    for (const auto& result : results)
        data.curves.push_back(curveOf(result, quantity));

    const auto& first = *results.front().table;
    const auto& y = *first.find(quantity);
    const std::string type = polarTypeOf(first);
    data.radiusTitle = QString::fromStdString(y.axisTitle());
    data.clockwise = type == "camera-azimuth";
    QString mode;
    if (type == "camera-azimuth") {
        mode = QStringLiteral("camera azimuth, view offset %1°").arg(offset_deg(first));
        data.directionNote = QStringLiteral("clockwise from the nose, 90° is starboard");
    } else if (type == "camera-elevation") {
        mode = QStringLiteral("camera elevation");
        data.directionNote = QStringLiteral("from the nose down: 90° belly, 180° tail, 270° top");
    } else {
        mode = QStringLiteral("model yaw, camera elevation %1°").arg(offset_deg(first));
        data.directionNote = QStringLiteral("yaw counter-clockwise, camera at the top");
    }
    data.title = titleOf(results, y, mode);
    return data;
}

} // namespace smat::gui
