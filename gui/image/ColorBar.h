#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QList>
#include <QWidget>

#include "gui/image/ColorRule.h"
#include "irsg/image/ColorMap.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QPainter;

namespace smat::gui {

struct PlotStyle;

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
    /// How limits and colours are found, as it is chosen here. The scale of the limits is what
    /// became of an automatic one.
    ColorRule rule() const;
    irsg::ColorScale scale() const;
    void setScale(irsg::ColorScale scale);
    bool marksOutside() const;
    void setMarksOutside(bool marks);
    /// For differences, whose colours are linear: no scale is offered.
    void hideScale();
    void setOutOfRange(const OutOfRange& counts);
    const OutOfRange& outOfRange() const { return outOfRange_; }
    const irsg::DisplayLimits& limits() const { return limits_; }
    const irsg::ColorMap& map() const { return *map_; }
    LimitMode mode() const;
    void setMode(LimitMode mode);
    /// Draws the colours with title, unit, values and counts, without what is typed.
    void drawLegend(QPainter& painter, QSize size, const PlotStyle& style, const QFont& font) const;
    /// Percentiles of the rule `percentile`, the lower one first.
    std::pair<double, double> percentiles() const;
    void setPercentiles(double low, double high);
    /// For limits that are symmetric: the lower percentile is not asked.
    void askUpperPercentileAlone();
    /// Locks these limits as if they had been typed in. LogicError unless low < high, both finite.
    void edit(const irsg::DisplayLimits& limits);
    /// What one press of the keys of exposure and offset changes.
    static constexpr double exposureStep = 0.25, offsetStep = 0.05;
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
    void marksChosen(bool marks);

  private:
    class Scale;
    void readLimits();
    void readPercentiles();
    void showPercentiles();
    void makeScaleBox();
    void makeMarks();
    QDoubleSpinBox* percentBox(const QString& name, double value, const QString& tip);
    void layOut();
    void connectParts();
    irsg::ColorScale shownScale() const;

    QString title_;
    const irsg::ColorMap* map_ = nullptr;
    irsg::DisplayLimits limits_;
    OutOfRange outOfRange_;
    Scale* scale_ = nullptr;
    QLineEdit* low_ = nullptr;
    QLineEdit* high_ = nullptr;
    QComboBox* mode_ = nullptr;
    QComboBox* colorScale_ = nullptr;
    QCheckBox* marks_ = nullptr;
    QDoubleSpinBox* lowPercent_ = nullptr;
    QDoubleSpinBox* highPercent_ = nullptr;
    bool upperAlone_ = false;
};

} // namespace smat::gui
