#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QPointF>
#include <QRectF>
#include <QString>

#include "gui/plot/DirectionLookup.h"
#include "gui/widgets/Theme.h"
#include "irsg/image/ColorMap.h"
#include "smatcore/tables/SignatureTable.h"

class QPainter;

namespace smat::gui {

/// A signature table as it is drawn: one column under one choice, as a map over azimuth and
/// elevation and as a ball, with one bar of colours. Cells below 0 are hatched, in decibels, which
/// have the size alone, as well, and counted.
class TableDrawing {
  public:
    /// Throws irsg::InputError as SignatureTable does.
    explicit TableDrawing(std::shared_ptr<const ResultTable> table);

    const SignatureTable& table() const { return table_; }
    QString title, conditions;

    /// What is shown. LogicError for a column that the table has not got.
    void setColumn(const std::string& key);
    const ResultColumn& column() const { return *column_; }
    void setChoice(const SignatureTable::Choice& choice);
    const SignatureTable::Choice& choice() const { return choice_; }
    void setDecibel(bool on);
    bool isDecibel() const { return isDecibel_; }
    void setColorMap(const std::string& name) { map_ = &irsg::ColorMap::named(name); }
    /// Where the ball is looked at from.
    void turnBall(double azimuth_deg, double elevation_deg);
    double ballAzimuth_deg() const { return ballAzimuth_deg_; }
    double ballElevation_deg() const { return ballElevation_deg_; }

    /// In the unit of the column, or dB over it.
    const irsg::DisplayLimits& limits() const { return limits_; }
    double shownValue(int direction) const;
    double value(int direction) const;
    int negativeCells() const { return negative_; }
    /// "12 of 2664 cells are negative"; empty where none is.
    QString negativeWords() const;
    QString barTitle() const;

    /// Draws all of it, its letters in `font` of the painter's device.
    void paint(QPainter& painter, const QRectF& area, const PlotStyle& style) const;
    /// The direction under a point of what was painted last into such an area; nothing beside map
    /// and ball.
    int directionAt(const QPointF& point, const QRectF& area, double letter) const;
    /// "Azimuth 35°, elevation 10°: 12.3 W·sr⁻¹".
    QString readout(int direction) const;
    /// Where the ball is, in an area whose letters are so high.
    QRectF ballIn(const QRectF& area, double letter) const;

    /// Azimuth, elevation and value of every direction as it is chosen.
    QString csv() const;

  private:
    struct Areas {
        QRectF map, ball, bar;
    };
    Areas areasOf(const QRectF& area, double letter) const;
    void findLimits();
    irsg::Rgb colorOf(int direction) const;
    QImage mapPicture(int width, int height) const;
    QImage ballPicture(int side, const QColor& around) const;
    void paintMap(QPainter& painter, const QRectF& area, const PlotStyle& style,
                  double letter) const;
    void paintBall(QPainter& painter, const QRectF& area, const PlotStyle& style,
                   double letter) const;
    void paintBar(QPainter& painter, const QRectF& area, const PlotStyle& style,
                  double letter) const;
    /// Direction of a place on the ball, -1 to 1 to the right and up; none outside.
    std::optional<SignatureTable::Direction> onBall(double right, double up) const;
    /// Where a direction is on it; none on the far side.
    std::optional<QPointF> placeOnBall(double azimuth_deg, double elevation_deg) const;

    std::shared_ptr<const ResultTable> held_;
    SignatureTable table_;
    DirectionLookup lookup_;
    const ResultColumn* column_ = nullptr;
    SignatureTable::Choice choice_;
    bool isDecibel_ = false;
    const irsg::ColorMap* map_ = nullptr;
    irsg::DisplayLimits limits_;
    int negative_ = 0;
    double ballAzimuth_deg_ = 35.0, ballElevation_deg_ = 20.0;
};

} // namespace smat::gui
