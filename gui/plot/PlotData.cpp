#include "gui/plot/PlotData.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <QStringList>

#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberFormat.h"
#include "irsg/core/Errors.h"
#include "smatcore/data/AkimaInterpolant.h"

namespace smat::gui {

void Curve::check() const {
    if (x.size() != y.size() || (!error.empty() && error.size() != y.size()) ||
        (!warnings.empty() && warnings.size() != y.size()) ||
        (isLayer() && base.size() != y.size()))
        throw irsg::LogicError("curve " + name.toStdString() + ": its columns differ in length");
}

namespace {

/// A run of finite samples of a smooth curve, `first` to `last`, and what lies between them.
struct SmoothRun {
    std::size_t first, last;
    AkimaInterpolant curve;
};

/// None where the curve is not smooth or cannot be. A turn without gaps is one run that closes.
std::vector<SmoothRun> smoothRuns(const Curve& curve, double period) {
    const auto &x = curve.x, &y = curve.y;
    std::vector<SmoothRun> runs;
    if (!curve.isSmooth || std::ranges::adjacent_find(x, std::greater_equal<>()) != x.end())
        return runs;
    const auto isThere = [&](std::size_t i) { return std::isfinite(x[i]) && std::isfinite(y[i]); };
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!isThere(i))
            continue;
        std::size_t last = i;
        while (last + 1 < x.size() && isThere(last + 1))
            ++last;
        const bool isWhole = i == 0 && last + 1 == x.size();
        const auto part = [&](const std::vector<double>& values) {
            return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(i),
                                       values.begin() + static_cast<std::ptrdiff_t>(last) + 1);
        };
        runs.push_back({i, last,
                        AkimaInterpolant(part(x), part(y),
                                         isWhole && curve.goesRound(period) ? period : 0.0)});
        i = last;
    }
    return runs;
}

/// Linear between samples.
std::optional<double> straightAt(const Curve& curve, double at) {
    const auto &x = curve.x, &y = curve.y;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double x0 = x[i];
        const double x1 = x[i + 1];
        const bool inside = (at - x0) * (at - x1) <= 0.0;
        if (!inside || !std::isfinite(y[i]) || !std::isfinite(y[i + 1]))
            continue;
        const double part = x1 == x0 ? 0.0 : (at - x0) / (x1 - x0);
        return y[i] + part * (y[i + 1] - y[i]);
    }
    if (x.size() == 1 && x[0] == at && std::isfinite(y[0]))
        return y[0];
    return std::nullopt;
}

} // namespace

bool Curve::goesRound(double period) const {
    return smat::goesRound(x, period);
}

Curve Curve::drawn(double period) const {
    const std::vector<SmoothRun> runs = smoothRuns(*this, period);
    if (runs.empty())
        return *this;
    constexpr int pieces = 8; // of a step: a cubic departs from them by 1/64 of what it does of one
    Curve more{name, {}, {}};
    if (isLayer())
        more.base = Curve{name, x, base, {}, isSmooth}.drawn(period).y;
    const auto add = [&](double at, double value, double half) {
        more.x.push_back(at);
        more.y.push_back(value);
        if (!error.empty())
            more.error.push_back(half);
        if (!warnings.empty())
            more.warnings.emplace_back();
    };
    const auto errorOf = [&](std::size_t i) { return error.empty() ? 0.0 : error[i]; };
    auto run = runs.begin();
    for (std::size_t i = 0; i < x.size(); ++i) {
        add(x[i], y[i], errorOf(i));
        if (!warnings.empty())
            more.warnings.back() = warnings[i];
        if (run != runs.end() && i > run->last)
            ++run;
        const bool closes = i + 1 == x.size() && goesRound(period) && runs.size() == 1 &&
                            runs.front().first == 0 && runs.front().last == i;
        if (run == runs.end() || i < run->first || (i == run->last && !closes))
            continue;
        const std::size_t next = closes ? 0 : i + 1;
        const double end = closes ? x[0] + period : x[next];
        for (int k = 1; k < pieces; ++k) {
            const double part = static_cast<double>(k) / pieces;
            add(x[i] + part * (end - x[i]), run->curve.between(i - run->first, part),
                errorOf(i) + part * (errorOf(next) - errorOf(i)));
        }
    }
    return more;
}

std::optional<double> Curve::valueAt(double at) const {
    for (const SmoothRun& run : smoothRuns(*this, 0.0))
        if (run.first < run.last && at >= x[run.first] && at <= x[run.last])
            return run.curve.at(at);
    return straightAt(*this, at);
}

std::optional<double> Curve::valueAt(double at, double period) const {
    if (x.empty())
        return std::nullopt;
    if (goesRound(period))
        if (const auto runs = smoothRuns(*this, period);
            runs.size() == 1 && runs.front().last + 1 == x.size() && runs.front().first == 0)
            return runs.front().curve.at(at);
    const double first = *std::min_element(x.begin(), x.end());
    double wrapped = std::fmod(at - first, period);
    if (wrapped < 0.0)
        wrapped += period;
    if (const auto value = valueAt(first + wrapped))
        return value;

    // Between the last sample and the first one of the next turn.
    const std::size_t last = x.size() - 1;
    Curve seam;
    seam.x = {x[last], x[0] + period};
    seam.y = {y[last], y[0]};
    const bool closes = seam.x[1] > seam.x[0] && seam.x[1] - seam.x[0] < 0.25 * period;
    return closes ? seam.valueAt(first + wrapped) : std::nullopt;
}

QString Curve::readoutAt(double at, double period) const {
    const auto read = [&](const Curve& curve) {
        return period > 0.0 ? curve.valueAt(at, period) : curve.valueAt(at);
    };
    const auto value = read(*this);
    if (!value)
        return QStringLiteral("no value");
    QString text = formattedNumber(*value);
    if (isLayer())
        text = formattedNumber(*value - read({name, x, base, {}, isSmooth}).value_or(0.0));
    if (error.empty())
        return text;
    if (const auto half = read({name, x, error}))
        text += QStringLiteral(" ± ") + QString::number(*half, 'g', 3);
    return text;
}

QString Curve::warningAt(double at, double period) const {
    if (warnings.empty())
        return {};
    double nearest = std::numeric_limits<double>::infinity();
    QString text;
    for (std::size_t i = 0; i < x.size(); ++i) {
        double distance = std::abs(at - x[i]);
        if (period > 0.0)
            distance = std::abs(std::remainder(at - x[i], period));
        if (!std::isfinite(y[i]) || !(distance < nearest))
            continue;
        nearest = distance;
        text = warnings[i];
    }
    return text;
}

namespace {

/// Null for what is shown as it is.
const ShownUnit* unitOfValues(const std::string& unit, const std::vector<Curve>& curves) {
    const ShownUnit* shown = shownUnitOf(unit);
    const bool isStack = std::ranges::any_of(curves, &Curve::isLayer);
    return shown != nullptr && shown->isLogarithmic && isStack ? nullptr : shown;
}

void showValues(const ShownUnit& unit, Curve& curve) {
    for (std::size_t i = 0; i < curve.error.size(); ++i)
        curve.error[i] = unit.error(curve.y[i], curve.error[i]);
    for (std::vector<double>* values : {&curve.y, &curve.base})
        std::ranges::transform(*values, values->begin(), unit.shown);
}

void showAbscissa(const ShownUnit& unit, Curve& curve) {
    std::ranges::transform(curve.x, curve.x.begin(), unit.shown);
    if (!unit.isReversed)
        return;
    for (std::vector<double>* values : {&curve.x, &curve.y, &curve.error, &curve.base})
        std::ranges::reverse(*values);
    std::ranges::reverse(curve.warnings);
}

} // namespace

PlotData inShownUnits(PlotData data) {
    const ShownUnit* x = shownUnitOf(data.xUnit);
    const ShownUnit* y = unitOfValues(data.yUnit, data.curves);
    for (Curve& curve : data.curves) {
        if (y != nullptr)
            showValues(*y, curve);
        if (x != nullptr)
            showAbscissa(*x, curve);
    }
    if (x != nullptr && !data.xTitle.isEmpty()) // else it stands at another plot
        data.xTitle = x->titleOf(data.xTitle);
    if (y != nullptr)
        data.yTitle = y->titleOf(data.yTitle);
    data.xLogarithmic = data.xLogarithmic && (x == nullptr || x->isReversed);
    data.yLogarithmic = data.yLogarithmic && (y == nullptr || y->isReversed);
    return data;
}

PolarData inShownUnits(PolarData data) {
    const ShownUnit* radius = unitOfValues(data.radiusUnit, data.curves);
    if (radius == nullptr)
        return data;
    for (Curve& curve : data.curves)
        showValues(*radius, curve);
    data.radiusTitle = radius->titleOf(data.radiusTitle);
    return data;
}

QString warningNote(const std::vector<Curve>& curves) {
    QStringList sentences;
    for (const Curve& curve : curves)
        for (std::size_t i = 0; i < curve.warnings.size(); ++i)
            if (std::isfinite(curve.y[i]) && !curve.warnings[i].isEmpty() &&
                !sentences.contains(curve.warnings[i]))
                sentences << curve.warnings[i];
    if (sentences.isEmpty())
        return {};
    return QStringLiteral("hollow points: ") +
           (sentences.size() == 1 ? sentences.front()
                                  : QStringLiteral("%1 warnings").arg(sentences.size()));
}

std::optional<Interval> rangeOf(const std::vector<Curve>& curves,
                                std::vector<double> Curve::*values, bool positiveOnly) {
    std::optional<Interval> range;
    for (const auto& curve : curves) {
        for (const double value : curve.*values) {
            if (!std::isfinite(value) || (positiveOnly && value <= 0.0))
                continue;
            if (!range)
                range = Interval{value, value};
            range->minimum = std::min(range->minimum, value);
            range->maximum = std::max(range->maximum, value);
        }
    }
    return range;
}

std::optional<Interval> rangeWithErrors(const std::vector<Curve>& curves, bool positiveOnly) {
    std::vector<Curve> edges = curves;
    for (const auto& curve : curves) {
        if (curve.isLayer())
            edges.push_back({curve.name, curve.x, curve.base});
        if (curve.error.empty())
            continue;
        Curve low = curve, high = curve;
        for (std::size_t i = 0; i < curve.error.size(); ++i) {
            low.y[i] -= curve.error[i];
            high.y[i] += curve.error[i];
        }
        edges.push_back(std::move(low));
        edges.push_back(std::move(high));
    }
    return rangeOf(edges, &Curve::y, positiveOnly);
}

namespace {

QString quotedField(QString text) {
    constexpr QStringView signs = u",;\t\"\n";
    if (std::ranges::none_of(text, [&](QChar sign) { return signs.contains(sign); }))
        return text;
    text.replace('"', "\"\"");
    return '"' + text + '"';
}

} // namespace

QString toCsv(const std::vector<Curve>& curves, const QString& xTitle, const QString& yTitle,
              std::optional<Interval> within, QChar separator) {
    if (curves.empty())
        return {};
    const bool sharedAxis = std::all_of(curves.begin(), curves.end(),
                                        [&](const Curve& c) { return c.x == curves[0].x; });

    QStringList header;
    std::size_t rows = 0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (i == 0 || !sharedAxis)
            header << quotedField(xTitle);
        const QString title = curves[i].name.isEmpty() ? yTitle : yTitle + ": " + curves[i].name;
        header << quotedField(title);
        if (!curves[i].error.empty())
            header << quotedField(QStringLiteral("Error of ") + title);
        if (!curves[i].warnings.empty())
            header << quotedField(curves.size() == 1 ? QStringLiteral("warning")
                                                     : QStringLiteral("Warning of ") + title);
        rows = std::max(rows, curves[i].x.size());
    }

    QStringList lines{header.join(separator)};
    for (std::size_t row = 0; row < rows; ++row) {
        QStringList cells;
        bool any = false;
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const Curve& curve = curves[i];
            const bool there =
                row < curve.x.size() &&
                (!within || (curve.x[row] >= within->minimum && curve.x[row] <= within->maximum));
            any = any || there;
            if (i == 0 || !sharedAxis)
                cells << (there ? exactNumber(curve.x[row]) : QString());
            cells << (there ? exactNumber(curve.valueOf(row)) : QString());
            if (!curve.error.empty())
                cells << (there ? exactNumber(curve.error[row]) : QString());
            if (!curve.warnings.empty())
                cells << (there ? quotedField(curve.warnings[row]) : QString());
        }
        if (any)
            lines << cells.join(separator);
    }
    return lines.join('\n') + '\n';
}

} // namespace smat::gui
