#include "gui/plot/ResultPlot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "gui/Readable.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/data/ColumnName.h"
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

/// The columns of a quantity. Throws InputError naming those that there are where it is missing.
std::vector<const ResultColumn*> requiredColumns(const NamedResult& result,
                                                 const std::string& quantity) {
    requireRows(*result.table, result.name.toStdString());
    auto columns = columnsOf(*result.table, quantity);
    if (columns.empty()) {
        std::string keys;
        for (const auto& key : plottableQuantities(*result.table))
            keys += (keys.empty() ? "" : ", ") + key;
        throw irsg::InputError(
            {result.name.toStdString(), "", "no column \"" + quantity + "\"", "one of " + keys});
    }
    return columns;
}

/// "run", of one of several columns "run: near, 3-5 µm"; the sum of several objects is "all".
QString curveName(const NamedResult& result, const ResultColumn& column, bool hasObjects) {
    ColumnName parts = ColumnName::of(column.key);
    if (hasObjects && parts.object.empty())
        parts.object = "all";
    const QString which = withReadableUnits(QString::fromStdString(parts.which()));
    return which.isEmpty() || result.name.isEmpty() ? result.name + which
                                                    : result.name + ": " + which;
}

void addCurves(std::vector<Curve>& curves, const NamedResult& result, const std::string& quantity) {
    const auto columns = requiredColumns(result, quantity);
    const bool hasObjects =
        std::any_of(columns.begin(), columns.end(), [](const ResultColumn* column) {
            return !ColumnName::of(column->key).object.empty();
        });
    for (const ResultColumn* column : columns) {
        Curve curve{columns.size() > 1 ? curveName(result, *column, hasObjects) : result.name,
                    abscissaOf(*result.table).values, column->values};
        if (const auto* error = result.table->find("error_" + column->key))
            curve.error = error->values;
        curves.push_back(std::move(curve));
    }
}

/// A column of the series without its values, which gives the axis its title.
ResultColumn titled(const ResultTable& table, const std::string& quantity) {
    const auto columns = columnsOf(table, quantity);
    return {quantity, columns.empty() ? "" : columns.front()->unit, {}};
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
    const QString words = title.left(title.indexOf(" ("));
    // Ernst Mach keeps his capital.
    return words.startsWith("Mach") ? words : words.toLower();
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
        if (isAbscissa(table, column) || error)
            continue;
        const std::string series = ColumnName::of(column.key).series();
        const std::string& key = columnsOf(table, series).size() > 1 ? series : column.key;
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            keys.push_back(key);
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

QString quantityTitle(const ResultTable& table, const std::string& quantity) {
    return QString::fromStdString(titled(table, quantity).axisTitle());
}

bool goOnOnePlot(const ResultTable& a, const ResultTable& b) {
    if (a.empty() || b.empty() || isPolar(a) != isPolar(b))
        return false;
    const bool sameAxis = isPolar(a) ? polarTypeOf(a) == polarTypeOf(b)
                                     : abscissaOf(a).header() == abscissaOf(b).header();
    try {
        return sameAxis && !columnsOf(b, plottableQuantities(a).front()).empty();
    } catch (const irsg::InputError&) {
        return false; // nothing in it can be drawn
    }
}

PlotData cartesianData(const std::vector<NamedResult>& results, const std::string& quantity) {
    requireSame(results, "abscissa",
                [](const ResultTable& t) { return t.empty() ? "none" : abscissaOf(t).header(); });
    PlotData data;
    for (const auto& result : results)
        addCurves(data.curves, result, quantity);

    const auto& first = *results.front().table;
    const auto& x = abscissaOf(first);
    const ResultColumn y = titled(first, quantity);
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
        addCurves(data.curves, result, quantity);

    const auto& first = *results.front().table;
    const ResultColumn y = titled(first, quantity);
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
