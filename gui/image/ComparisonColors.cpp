#include "gui/image/ComparisonColors.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <QWidget>

namespace smat::gui {
namespace {

/// Limits at equal distances from 1, for a ratio.
irsg::DisplayLimits aroundOne(const std::vector<float>& values, double percent) {
    std::vector<float> distances;
    distances.reserve(values.size());
    for (const float value : values)
        if (std::isfinite(value))
            distances.push_back(value - 1.0F);
    const irsg::DisplayLimits limits = irsg::symmetricLimits(distances, percent);
    return {1.0 + limits.low, 1.0 + limits.high};
}

irsg::DisplayLimits differenceLimits(const std::vector<float>& values, irsg::DifferenceMode mode,
                                     double percent) {
    switch (mode) {
    case irsg::DifferenceMode::absolute:
        return {0.0, irsg::symmetricLimits(values, percent).high};
    case irsg::DifferenceMode::ratio:
        return aroundOne(values, percent);
    default:
        return irsg::symmetricLimits(values, percent);
    }
}

constexpr double usualPercent = 99.5; ///< of the differences have colours of the map

/// At once for small planes, in another thread for large ones, after `await`.
void find(LatestTask& task, std::size_t pixels, const std::function<FoundLimits()>& work,
          const std::function<void()>& await, const std::function<void(FoundLimits)>& use) {
    task.cancel();
    if (pixels <= quickPixels) {
        use(work());
        return;
    }
    await();
    task.run<FoundLimits>(work, use);
}

} // namespace

ComparisonColors::ComparisonColors(QWidget* panes) : QObject(panes) {
    map_ = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
    shared_ = new ColorBar(panes);
    shared_->setObjectName("sharedBar");
    shared_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
    // A few pixels at edges differ by much; the rest shows only where they do not set the limits.
    difference_ = new ColorBar(panes, {LimitMode::percentile, LimitMode::full, LimitMode::locked});
    difference_->setObjectName("differenceBar");
    difference_->setPercentiles(0.0, usualPercent);
    difference_->askUpperPercentileAlone();
    difference_->hideScale();

    connect(shared_, &ColorBar::limitsEdited, this, &ComparisonColors::findShared);
    connect(shared_, &ColorBar::modeChosen, this, &ComparisonColors::findShared);
    connect(shared_, &ColorBar::scaleChosen, this, &ComparisonColors::findShared);
    connect(shared_, &ColorBar::marksChosen, this, &ComparisonColors::findShared);
    connect(difference_, &ColorBar::marksChosen, this, &ComparisonColors::findDifference);
    connect(difference_, &ColorBar::limitsEdited, this, &ComparisonColors::findDifference);
    connect(difference_, &ColorBar::modeChosen, this, &ComparisonColors::findDifference);
}

void ComparisonColors::setPlanes(const std::array<SharedValues, 2>& planes, const QString& title) {
    planes_ = planes;
    shared_->setTitle(title);
    findShared();
}

void ComparisonColors::setDifference(SharedValues values, irsg::DifferenceMode mode,
                                     const QString& title) {
    differenceValues_ = std::move(values);
    if (mode != mode_ && difference_->mode() == LimitMode::locked)
        difference_->setMode(LimitMode::percentile); // limits of another quantity
    mode_ = mode;
    difference_->setTitle(title);
    if (differenceValues_)
        findDifference();
    else
        differenceTask_.cancel();
}

void ComparisonColors::setColorMap(const std::string& name) {
    map_ = &irsg::ColorMap::named(name);
    shared_->setColors(*map_, shared_->limits());
    emit sharedFound(*map_, shared_->limits());
    findDifference();
}

void ComparisonColors::findShared() {
    std::vector<SharedValues> planes;
    std::size_t pixels = 0;
    for (const SharedValues& plane : planes_) {
        if (!plane)
            continue;
        planes.push_back(plane);
        pixels = std::max(pixels, plane->size());
    }
    std::optional<irsg::DisplayLimits> known;
    if (shared_->mode() == LimitMode::locked)
        known = shared_->limits();
    find(
        sharedTask_, pixels,
        [planes, known, rule = shared_->rule()] { return findLimits(rule, planes, known); },
        [this] { emit sharedAwaited(); }, [this](const FoundLimits& found) { useShared(found); });
}

void ComparisonColors::useShared(const FoundLimits& found) {
    shared_->setColors(*map_, found.limits);
    shared_->setOutOfRange(found.outside);
    emit sharedFound(*map_, found.limits);
}

void ComparisonColors::findDifference() {
    if (!differenceValues_)
        return;
    std::optional<irsg::DisplayLimits> known;
    if (difference_->mode() == LimitMode::locked)
        known = difference_->limits();
    const double percent =
        difference_->mode() == LimitMode::percentile ? difference_->percentiles().second : 100.0;
    find(
        differenceTask_, differenceValues_->size(),
        [values = differenceValues_, mode = mode_, known, percent,
         marks = difference_->marksOutside()] {
            irsg::DisplayLimits limits = known ? *known : differenceLimits(*values, mode, percent);
            limits.scale = irsg::ColorScale::linear;
            limits.marksOutside = marks;
            return FoundLimits{limits, countOutOfRange(*values, limits)};
        },
        [this] { emit differenceAwaited(); },
        [this](const FoundLimits& found) { useDifference(found); });
}

void ComparisonColors::useDifference(const FoundLimits& found) {
    // What has a sign diverges from its middle; a size does not.
    const irsg::ColorMap& map =
        mode_ == irsg::DifferenceMode::absolute ? *map_ : irsg::ColorMap::named("diverging");
    difference_->setColors(map, found.limits);
    difference_->setOutOfRange(found.outside);
    emit differenceFound(map, found.limits);
}

} // namespace smat::gui

#include "moc_ComparisonColors.cpp"
