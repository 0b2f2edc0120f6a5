#include "gui/plot/ResultPlot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <QObject>

#include "gui/widgets/NumberFormat.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/data/ResultDifference.h"
#include "smatcore/project/AnalysisKind.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/NearestNames.h"

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
        throw irsg::InputError({result.name.toStdString(), "", "no column \"" + quantity + "\"",
                                oneOf(plottableQuantities(*result.table), quantity)});
    }
    return columns;
}

/// "run", of one of several columns "run: near, 3-5 µm"; the sum of several objects is "all".
QString curveName(const NamedResult& result, const ResultColumn& column, bool hasObjects) {
    ColumnName parts = ColumnName::of(column.key);
    if (hasObjects && parts.object.empty())
        parts.object = "all";
    const QString which = withFormattedUnits(QString::fromStdString(parts.which()));
    return which.isEmpty() || result.name.isEmpty() ? result.name + which
                                                    : result.name + ": " + which;
}

/// Rows from one turn of a polar plot to the next: its angle begins anew at another elevation.
struct Turn {
    std::size_t first = 0, last = 0; ///< rows first to last - 1
    QString name;
};
std::vector<Turn> turnsOf(const ResultTable& table) {
    const std::vector<double>& angle = abscissaOf(table).values;
    std::vector<Turn> turns{{0, angle.size(), {}}};
    const auto* elevation = table.find(irsg::Quantity::elevation);
    if (!isPolar(table) || elevation == nullptr)
        return turns;
    for (std::size_t i = 1; i < angle.size(); ++i)
        if (angle[i] <= angle[i - 1]) {
            turns.back().last = i;
            turns.push_back({i, angle.size(), {}});
        }
    if (turns.size() > 1)
        for (Turn& turn : turns)
            turn.name = QStringLiteral("elevation %1°").arg(elevation->values[turn.first]);
    return turns;
}

std::vector<double> part(const std::vector<double>& values, const Turn& turn) {
    return {values.begin() + static_cast<std::ptrdiff_t>(turn.first),
            values.begin() + static_cast<std::ptrdiff_t>(turn.last)};
}

/// Of the samples of a turn; empty where none warns of anything.
std::vector<QString> warningsOf(const ResultTable& table, const Turn& turn) {
    std::vector<QString> warnings;
    bool isAny = false;
    for (std::size_t row = turn.first; row < turn.last && !table.warnings().empty(); ++row) {
        warnings.push_back(QString::fromStdString(table.warnings()[row]));
        isAny = isAny || !warnings.back().isEmpty();
    }
    return isAny ? warnings : std::vector<QString>();
}

/// What the results warn of, with their names where there are several.
QStringList headWarnings(const std::vector<NamedResult>& results) {
    QStringList all;
    for (const NamedResult& result : results)
        for (const auto& [key, value] : result.table->provenance.entries)
            if (key == "warning")
                all << (results.size() > 1 ? result.name + ": " : QString()) +
                           QString::fromStdString(value);
    return all;
}

QString joined(const QString& a, const QString& b) {
    return a.isEmpty() || b.isEmpty() ? a + b : a + ", " + b;
}

/// Without a name.
Curve curveOf(const NamedResult& result, const ResultColumn& column, const Turn& turn) {
    Curve curve{{}, part(abscissaOf(*result.table).values, turn), part(column.values, turn)};
    if (const ResultColumn* error = result.table->find("error_" + column.key); error != nullptr)
        curve.error = part(error->values, turn);
    curve.warnings = warningsOf(*result.table, turn);
    curve.isSmooth = isAdaptive(*result.table);
    return curve;
}

void addCurves(std::vector<Curve>& curves, const NamedResult& result, const std::string& quantity) {
    const auto columns = requiredColumns(result, quantity);
    const bool hasObjects =
        std::any_of(columns.begin(), columns.end(), [](const ResultColumn* column) {
            return !ColumnName::of(column->key).object.empty();
        });
    for (const ResultColumn* column : columns) {
        const QString name =
            columns.size() > 1 ? curveName(result, *column, hasObjects) : result.name;
        for (const Turn& turn : turnsOf(*result.table)) {
            const bool isOnlyName = !turn.name.isEmpty() && columns.size() == 1 && result.isAlone;
            Curve curve = curveOf(result, *column, turn);
            curve.name = isOnlyName ? turn.name : joined(name, turn.name);
            curves.push_back(std::move(curve));
        }
    }
}

/// Layers of a stack, the rest among them as one.
constexpr std::size_t mostLayers = 7; // with the sum as many as there are colours

/// The columns of a stack: the sum, and what adds up to it.
struct StackColumns {
    const ResultColumn* sum = nullptr;
    std::vector<const ResultColumn*> layers;
};

/// Without a sum where there is no stack.
StackColumns stackOf(const ResultTable& table, const std::string& quantity) {
    StackColumns stack;
    std::vector<const ResultColumn*> objects;
    for (const ResultColumn* column : columnsOf(table, quantity)) {
        const ColumnName name = ColumnName::of(column->key);
        if (name.object.empty() && stack.sum != nullptr)
            return {}; // another band
        if (name.object.empty())
            stack.sum = column;
        else
            (name.part().empty() ? objects : stack.layers).push_back(column);
    }
    if (stack.layers.empty())
        stack.layers = std::move(objects);
    if (stack.layers.empty() || turnsOf(table).size() > 1)
        stack.sum = nullptr;
    return stack;
}

/// "exhaust", or "near/exhaust" where several objects have parts.
QString layerName(const StackColumns& stack, const ResultColumn& layer) {
    const ColumnName name = ColumnName::of(layer.key);
    const std::string object = name.object.substr(0, name.object.size() - name.part().size());
    const bool isOfOne = std::ranges::all_of(stack.layers, [&](const ResultColumn* other) {
        return ColumnName::of(other->key).object.starts_with(object);
    });
    return QString::fromStdString(isOfOne && !name.part().empty() ? name.part() : name.object);
}

/// The layers of a stack and its sum; `result` can be stacked.
void addStack(std::vector<Curve>& curves, const NamedResult& result, const std::string& quantity) {
    StackColumns stack = stackOf(*result.table, quantity);
    const auto size = [](const ResultColumn* column) {
        double sum = 0.0;
        for (const double value : column->values)
            sum += std::isfinite(value) ? std::abs(value) : 0.0;
        return sum;
    };
    std::erase_if(stack.layers, [&](const ResultColumn* column) { return !(size(column) > 0.0); });
    std::ranges::stable_sort(stack.layers, std::ranges::greater(), size);
    const std::vector<double>& x = abscissaOf(*result.table).values;
    std::vector<double> above(x.size(), 0.0), below(x.size(), 0.0); // what lies there already
    const auto add = [&](const QString& name, const std::vector<double>& values) {
        Curve layer{name, x, {}};
        for (std::size_t i = 0; i < x.size(); ++i) {
            double& reached = values[i] < 0.0 ? below[i] : above[i];
            layer.base.push_back(reached);
            layer.y.push_back(reached + values[i]);
            reached += std::isfinite(values[i]) ? values[i] : 0.0;
        }
        layer.isSmooth = isAdaptive(*result.table);
        curves.push_back(std::move(layer));
    };
    // More than these could not be told apart.
    const std::size_t shown =
        stack.layers.size() > mostLayers ? mostLayers - 1 : stack.layers.size();
    for (std::size_t k = 0; k < shown; ++k)
        add(layerName(stack, *stack.layers[k]), stack.layers[k]->values);
    std::vector<double> rest(x.size(), 0.0);
    for (std::size_t k = shown; k < stack.layers.size(); ++k)
        for (std::size_t i = 0; i < x.size(); ++i)
            rest[i] += stack.layers[k]->values[i];
    if (shown < stack.layers.size())
        add(QObject::tr("%1 others").arg(stack.layers.size() - shown), rest);
    Curve whole = curveOf(result, *stack.sum, turnsOf(*result.table).front());
    whole.name = QObject::tr("all");
    curves.push_back(std::move(whole));
}

void addTo(std::vector<Curve>& curves, const std::vector<NamedResult>& results,
           const std::string& quantity, bool stacked) {
    if (stacked && (results.size() != 1 || !canStack(*results.front().table, quantity)))
        throw irsg::LogicError("a stack was asked of what cannot be one");
    for (const NamedResult& result : results)
        stacked ? addStack(curves, result, quantity) : addCurves(curves, result, quantity);
}

/// The unit of what may be shown in another one: no differences and errors.
std::string displayedUnitOf(const ResultColumn& column) {
    using irsg::Quantity;
    const ColumnName name = ColumnName::of(column.key);
    const std::optional<Quantity> quantity = irsg::quantityOfKey(name.quantity);
    constexpr std::array shown{Quantity::wavelength,     Quantity::wavenumber,
                               Quantity::temperature,    Quantity::apparentTemperature,
                               Quantity::intensity,      Quantity::contrastIntensity,
                               Quantity::sourceIntensity};
    const bool isShown =
        name.prefix.empty() && quantity && std::ranges::find(shown, *quantity) != shown.end();
    return isShown ? column.unit : std::string();
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

/// With the name of a lone result where it does not stand at its curve.
QString titleOf(const std::vector<NamedResult>& results, const std::vector<Curve>& curves,
                const ResultColumn& column, const QString& over) {
    QString label = QString::fromStdString(column.axisTitle());
    label = label.left(label.indexOf(" ("));
    QString title = label + " over " + over;
    const auto namesIt = [&](const Curve& curve) { return curve.name == results[0].name; };
    if (results.size() == 1 && !results[0].name.isEmpty() && std::ranges::none_of(curves, namesIt))
        title += QStringLiteral(" – ") + results[0].name;
    return title;
}

/// What all share, and below what hollow points warn of.
QString conditionsLine(const std::vector<NamedResult>& results, const std::vector<Curve>& curves) {
    std::vector<const ResultTable*> tables;
    for (const NamedResult& result : results)
        tables.push_back(result.table);
    const QString line = QString::fromStdString(lineOf(sharedConditions(tables)));
    const QString note = warningNote(curves);
    return line.isEmpty() || note.isEmpty() ? line + note : line + '\n' + note;
}

QString plainLabel(const ResultColumn& column) {
    const QString title = QString::fromStdString(column.axisTitle());
    const QString words = title.left(title.indexOf(" ("));
    // Ernst Mach keeps his capital.
    return words.startsWith("Mach") ? words : words.toLower();
}

/// A profile of the air: its altitude goes up, as everybody draws it.
bool isProfile(const ResultTable& table) {
    return resultKindOf(table.provenance) == AnalysisKind::temperatureProfile;
}

/// Where along the range the horizon begins to hide an object, and where it hides all of it.
std::vector<PlotMark> horizonMarks(const std::vector<NamedResult>& results) {
    std::vector<PlotMark> marks;
    const auto add = [&](const PlotMark& mark) {
        if (std::ranges::find(marks, mark) == marks.end())
            marks.push_back(mark);
    };
    for (const NamedResult& result : results) {
        const ResultColumn& range = abscissaOf(*result.table);
        if (range.key != irsg::info(irsg::Quantity::range).key)
            continue;
        for (const ResultColumn* hidden : columnsOf(*result.table, "hidden_by_horizon")) {
            const QString object = QString::fromStdString(ColumnName::of(hidden->key).object);
            const QString of = object.isEmpty() ? QString() : object + ' ';
            // The first beyond it, as ranges ascend.
            const auto addFrom = [&](double least, const QString& words) {
                for (std::size_t i = 0; i < hidden->values.size(); ++i)
                    if (hidden->values[i] >= least && hidden->values[i] > 0.0)
                        return add({range.values[i], of + words});
            };
            addFrom(0.0, QStringLiteral("partly behind the horizon"));
            addFrom(1.0, QStringLiteral("behind the horizon"));
        }
    }
    return marks;
}

/// "view offset 12°": the elevation of a camera-azimuth sweep, the same in all rows of a turn.
QString offsetWords(const ResultTable& table) {
    const auto* elevation = table.find(irsg::Quantity::elevation);
    if (turnsOf(table).size() > 1)
        return QStringLiteral("several view offsets");
    return QStringLiteral("view offset %1°")
        .arg(elevation == nullptr || elevation->values.empty() ? 0.0 : elevation->values.front());
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

bool canStack(const ResultTable& table, const std::string& quantity) {
    return !table.empty() && stackOf(table, quantity).sum != nullptr;
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

PlotData cartesianData(const std::vector<NamedResult>& results, const std::string& quantity,
                       bool stacked) {
    requireSame(results, "abscissa",
                [](const ResultTable& t) { return t.empty() ? "none" : abscissaOf(t).header(); });
    PlotData data;
    addTo(data.curves, results, quantity, stacked);

    const auto& first = *results.front().table;
    const auto& x = abscissaOf(first);
    const ResultColumn y = titled(first, quantity);
    data.title = titleOf(results, data.curves, y, plainLabel(x));
    data.conditions = conditionsLine(results, data.curves);
    data.warnings = headWarnings(results);
    data.marks = horizonMarks(results);
    data.xTitle = QString::fromStdString(x.axisTitle());
    data.yTitle = QString::fromStdString(y.axisTitle());
    data.xUnit = displayedUnitOf(x);
    data.yUnit = displayedUnitOf(y);

    // What was spaced by equal ratios is read on a logarithmic axis.
    for (const BooleanKey spacing : {key::rangeLog, key::conditionLog})
        data.xLogarithmic = data.xLogarithmic || first.provenance.value(spacing) == "true";
    if (isProfile(first)) {
        std::swap(data.xTitle, data.yTitle);
        std::swap(data.xUnit, data.yUnit);
        for (Curve& curve : data.curves) {
            std::swap(curve.x, curve.y);
            curve.error.clear();
        }
    }
    return data;
}

PolarData polarData(const std::vector<NamedResult>& results, const std::string& quantity,
                    bool stacked) {
    requireSame(results, "a polar plot of type", polarTypeOf);
    PolarData data;
    addTo(data.curves, results, quantity, stacked);

    const auto& first = *results.front().table;
    const ResultColumn y = titled(first, quantity);
    const std::string type = polarTypeOf(first);
    data.radiusTitle = QString::fromStdString(y.axisTitle());
    data.radiusUnit = displayedUnitOf(y);
    data.clockwise = type == "camera-azimuth";
    QString mode;
    if (type == "camera-azimuth") {
        mode = QStringLiteral("camera azimuth, ") + offsetWords(first);
        data.directionNote = QStringLiteral("clockwise from the nose, 90° is starboard");
    } else if (type == "camera-elevation") {
        mode = QStringLiteral("camera elevation");
        data.directionNote = QStringLiteral("from the nose down: 90° belly, 180° tail, 270° top");
    } else {
        mode = QStringLiteral("model yaw");
        data.directionNote = QStringLiteral("yaw counter-clockwise, camera at the top");
    }
    data.title = titleOf(results, data.curves, y, mode);
    data.conditions = conditionsLine(results, data.curves);
    data.warnings = headWarnings(results);
    return data;
}

} // namespace smat::gui
