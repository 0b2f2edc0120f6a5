#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

namespace smat::gui {

/// One line of a plot. A sample whose y (or x) is not finite is a gap: nothing is drawn there.
struct Curve {
    QString name;
    std::vector<double> x, y;
    std::vector<double> error = {}; ///< half the width of a band about y; empty for none
    /// Its samples follow it, so that it is AkimaInterpolant between them, not straight lines;
    /// where x ascends.
    bool isSmooth = false;
    std::vector<QString> warnings = {}; ///< of each sample, "" for nothing; empty for none at all
    /// Of a layer of a stack, whose area goes from here to y: its own value is the difference.
    /// Empty for a line.
    std::vector<double> base = {};

    /// LogicError where the columns differ in length.
    void check() const;

    /// Whether it goes all the way round an axis that repeats but for its last step.
    bool goesRound(double period) const;
    /// The curve with as many samples as a line needs that is drawn straight between them: more
    /// where it is smooth, else the same. `period` as of valueAt.
    Curve drawn(double period = 0.0) const;

    bool isLayer() const { return !base.empty(); }
    /// What sample `i` says: y, of a layer its height.
    double valueOf(std::size_t i) const { return isLayer() ? y[i] - base[i] : y[i]; }
    /// y at `at`, linear between samples or as it is smooth; nothing outside the samples and beside
    /// gaps.
    std::optional<double> valueAt(double at) const;
    /// The same on an axis that repeats after `period`.
    std::optional<double> valueAt(double at, double period) const;
    /// "12.5 ± 0.3", of a layer its height, or "no value"; `period` 0 for an axis that does not
    /// repeat.
    QString readoutAt(double at, double period = 0.0) const;

    /// What sample `i` warns of, "" for nothing.
    QString warningOf(std::size_t i) const { return warnings.empty() ? QString() : warnings[i]; }
    /// What the sample next to `at` warns of that is drawn, "" for nothing; `period` as of
    /// readoutAt.
    QString warningAt(double at, double period = 0.0) const;
};

/// An upright line across a plot with a label.
struct PlotMark {
    double x = 0.0;
    QString label;
    bool operator==(const PlotMark&) const = default;
};

/// What a Cartesian plot shows. Titles hold their units.
struct PlotData {
    QString title, xTitle, yTitle;
    QString conditions = {}; ///< a line below the title: band, range, aspect, ...
    std::vector<Curve> curves;
    bool xLogarithmic = false, yLogarithmic = false;
    QStringList warnings = {}; ///< of the results, for the head of their values
    std::vector<PlotMark> marks = {};
    /// Units of the values that may be shown as others (DisplayUnits); empty: as they are.
    std::string xUnit = {}, yUnit = {};
};

/// What a polar plot shows: x of the curves is the angle in degrees, 0 drawn at the top.
struct PolarData {
    QString title;         ///< with mode and offset
    QString conditions;    ///< as of PlotData
    QString radiusTitle;   ///< with its unit
    QString directionNote; ///< "angle grows clockwise, seen from above"
    bool clockwise = true;
    std::vector<Curve> curves;
    QStringList warnings = {};   ///< as of PlotData
    std::string radiusUnit = {}; ///< as of PlotData
};

/// The same in the units that are shown now. Layers of a stack stay where the other unit is
/// logarithmic: they would not add up.
PlotData inShownUnits(PlotData data);
PolarData inShownUnits(PolarData data);

/// A closed interval; empty when there is nothing to enclose.
struct Interval {
    double minimum = 0.0, maximum = 0.0;
    bool operator==(const Interval&) const = default;
};
/// Range of the finite values, the positive ones alone for a logarithmic axis.
std::optional<Interval> rangeOf(const std::vector<Curve>& curves,
                                std::vector<double> Curve::*values, bool positiveOnly);
/// The same of y, with the errors about it.
std::optional<Interval> rangeWithErrors(const std::vector<Curve>& curves, bool positiveOnly);

/// "Hollow points: SENTENCE" where the curves have samples that warn of something, or how many
/// sentences there are; else "".
QString warningNote(const std::vector<Curve>& curves);

/// CSV of the curves: a column pair per curve where their x differ, one x column where all agree.
/// Errors follow their curve, then its warnings where it has any. `within` keeps the part of x that
/// is visible. Cells are separated by `separator`: spreadsheets take tabs from the clipboard.
/// Numbers read back exactly.
QString toCsv(const std::vector<Curve>& curves, const QString& xTitle, const QString& yTitle,
              std::optional<Interval> within = {}, QChar separator = ',');

} // namespace smat::gui
