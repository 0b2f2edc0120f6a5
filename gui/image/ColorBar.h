#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QList>
#include <QWidget>

#include "gui/image/ColoredPlane.h"
#include "irsg/image/ColorMap.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;

namespace smat::gui {

/// How the limits of the colours are found.
enum class LimitMode {
    target,     ///< irsg::limitsFor
    full,       ///< least to largest
    percentile, ///< the percentiles that are typed in
    locked      ///< as typed in
};

/// Values that lie outside of the limits.
struct OutOfRange {
    std::size_t below = 0, above = 0, nan = 0;
};

/// The legend of a false-colour picture: the colours with their values and unit, the colours of
/// what lies outside of the limits and of what is no number with their counts, the two limits as
/// numbers to edit, and the rule that sets them.
class ColorBar : public QWidget {
    Q_OBJECT

  public:
    /// Offers these rules, the first one being in effect.
    explicit ColorBar(QWidget* parent = nullptr,
                      const QList<LimitMode>& modes = {LimitMode::target, LimitMode::full,
                                                       LimitMode::percentile, LimitMode::locked});

    void setTitle(const QString& title);
    const QString& title() const { return title_; }
    void setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits);
    /// How colours follow values; with the limits it comes from setColors.
    irsg::ColorScale scale() const;
    void setScale(irsg::ColorScale scale);
    /// For differences, whose colours are linear: no scale is offered.
    void hideScale();
    void setOutOfRange(const OutOfRange& counts);
    const OutOfRange& outOfRange() const { return outOfRange_; }
    const irsg::DisplayLimits& limits() const { return limits_; }
    const irsg::ColorMap& map() const { return *map_; }
    LimitMode mode() const;
    void setMode(LimitMode mode);
    /// The colours with title, unit, values and counts as they are drawn now, without what is
    /// typed.
    QPixmap legend() const;
    /// Percentiles of the rule `percentile`, the lower one first.
    std::pair<double, double> percentiles() const;
    void setPercentiles(double low, double high);
    /// For limits that are symmetric: the lower percentile is not asked.
    void askUpperPercentileAlone();
    /// Locks these limits as if they had been typed in. LogicError unless low < high, both finite.
    void edit(const irsg::DisplayLimits& limits);
    /// Multiplies the exposure by 2^stops: the upper limit comes nearer to the lower one, or both
    /// limits to 0 where the map is diverging.
    void changeExposure(double stops);
    /// Moves both limits by a part of their distance.
    void changeOffset(double part);

  signals:
    void limitsEdited(const irsg::DisplayLimits& limits);
    /// Another rule, or other percentiles.
    void modeChosen(LimitMode mode);
    void scaleChosen(irsg::ColorScale scale);

  private:
    class Scale;
    void readLimits();
    void readPercentiles();
    void showPercentiles();

    QString title_;
    const irsg::ColorMap* map_ = nullptr;
    irsg::DisplayLimits limits_;
    OutOfRange outOfRange_;
    Scale* scale_ = nullptr;
    QLineEdit* low_ = nullptr;
    QLineEdit* high_ = nullptr;
    QComboBox* mode_ = nullptr;
    QComboBox* colorScale_ = nullptr;
    QDoubleSpinBox* lowPercent_ = nullptr;
    QDoubleSpinBox* highPercent_ = nullptr;
    bool upperAlone_ = false;
};

/// Limits of colours with what lies outside of them.
struct FoundLimits {
    irsg::DisplayLimits limits;
    OutOfRange outside;
};
/// Those of planes that share their colours: `known` ones, or as the rule says, see
/// automaticLimits; in either case with the scale.
FoundLimits limitsOf(const std::vector<SharedValues>& planes,
                     const std::optional<irsg::DisplayLimits>& known, LimitMode mode,
                     std::pair<double, double> percentiles, irsg::ColorScale scale);

/// Counted in one sweep.
OutOfRange countOutOfRange(const std::vector<float>& values, const irsg::DisplayLimits& limits);
/// Limits of the rules but `locked`, for one plane or for several that share them.
irsg::DisplayLimits automaticLimits(const std::vector<const std::vector<float>*>& planes,
                                    LimitMode mode, std::pair<double, double> percentiles,
                                    irsg::ColorScale scale);

} // namespace smat::gui
