#include "gui/project/PlacingPicture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include "irsg/geometry/conversion/OsgValues.h"

namespace smat::gui {
namespace {

constexpr double man_m = 1.8;

/// A side of a model: what points right and up in it, and what towards the eye.
struct Side {
    osg::Vec3d right, up, eye;
    QString name;
};

/// Draws triangles on a small picture, nearest in front, shaded by how they face the eye.
class Sketch {
  public:
    Sketch(QSize size, double devicePixelRatio, const QColor& body)
        : picture_(size * devicePixelRatio, QImage::Format_ARGB32_Premultiplied),
          depth_(static_cast<std::size_t>(picture_.width()) *
                     static_cast<std::size_t>(picture_.height()),
                 -HUGE_VAL),
          body_(body) {
        picture_.fill(Qt::transparent);
        picture_.setDevicePixelRatio(devicePixelRatio);
    }

    /// Corners in pixels of the picture, z towards the eye.
    void add(const std::array<osg::Vec3d, 3>& p, double facing) {
        const double area = (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) -
                            (p[2].x() - p[0].x()) * (p[1].y() - p[0].y());
        const auto [left, right] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
        const auto [top, bottom] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
        const int x0 = std::max(0, static_cast<int>(std::floor(left))),
                  x1 = std::min(picture_.width() - 1, static_cast<int>(std::ceil(right))),
                  y0 = std::max(0, static_cast<int>(std::floor(top))),
                  y1 = std::min(picture_.height() - 1, static_cast<int>(std::ceil(bottom)));
        const double light = 0.45 + 0.55 * std::abs(facing);
        const QRgb colour =
            qRgb(static_cast<int>(body_.red() * light), static_cast<int>(body_.green() * light),
                 static_cast<int>(body_.blue() * light));
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const double px = x + 0.5, py = y + 0.5;
                const double a = ((p[1].x() - px) * (p[2].y() - py) -
                                  (p[2].x() - px) * (p[1].y() - py)) /
                                 area,
                             b = ((p[2].x() - px) * (p[0].y() - py) -
                                  (p[0].x() - px) * (p[2].y() - py)) /
                                 area,
                             c = 1.0 - a - b;
                if (!(a >= 0.0 && b >= 0.0 && c >= 0.0))
                    continue;
                const double z = a * p[0].z() + b * p[1].z() + c * p[2].z();
                double& nearest = depth_[static_cast<std::size_t>(y) *
                                             static_cast<std::size_t>(picture_.width()) +
                                         static_cast<std::size_t>(x)];
                if (z > nearest) {
                    nearest = z;
                    picture_.setPixel(x, y, colour);
                }
            }
    }
    const QImage& picture() const { return picture_; }

  private:
    QImage picture_;
    std::vector<double> depth_;
    QColor body_;
};

/// A standing man whose feet are at the middle of the lower edge.
QPainterPath manIn(const QRectF& box) {
    QPainterPath path;
    const double h = box.height(), x = box.center().x(), top = box.top();
    path.addEllipse(QPointF(x, top + 0.07 * h), 0.06 * h, 0.07 * h);
    path.addRoundedRect(QRectF(x - 0.11 * h, top + 0.16 * h, 0.22 * h, 0.36 * h), 0.05 * h,
                        0.05 * h);
    path.addRect(QRectF(x - 0.09 * h, top + 0.5 * h, 0.075 * h, 0.5 * h));
    path.addRect(QRectF(x + 0.015 * h, top + 0.5 * h, 0.075 * h, 0.5 * h));
    return path;
}

} // namespace

PlacingPicture::PlacingPicture(QWidget* parent) : QWidget(parent) {
    setObjectName("placingPicture");
    setMinimumHeight(150);
}

void PlacingPicture::show(std::shared_ptr<const irsg::ModelShape> shape,
                          const irsg::ModelPlacing& placing) {
    shape_ = std::move(shape);
    placing_ = placing;
    word_.clear();
    update();
}

void PlacingPicture::showWord(const QString& word) {
    shape_.reset();
    word_ = word;
    update();
}

void PlacingPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    painter.setPen(palette().placeholderText().color());
    if (!shape_) {
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                         word_);
        return;
    }
    const osg::Matrixd toModel = irsg::toOsg(irsg::turnAndScale(placing_));
    osg::Vec3d low(HUGE_VAL, HUGE_VAL, HUGE_VAL), high = -low;
    std::vector<osg::Vec3d> corners;
    corners.reserve(shape_->corners.size());
    for (const irsg::Float3& corner : shape_->corners) {
        corners.push_back(osg::Vec3d(irsg::toOsg(corner)) * toModel);
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], corners.back()[axis]);
            high[axis] = std::max(high[axis], corners.back()[axis]);
        }
    }
    const osg::Vec3d size = high - low, centre = (low + high) * 0.5;
    const double unit_m = std::max({size.x(), size.y(), size.z(), 1e-9});

    // From port the nose is on the left.
    const std::array<Side, 3> sides = {Side{{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}, tr("from port")},
                                       Side{{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}, tr("from ahead")},
                                       Side{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, tr("from above")}};
    const int words = fontMetrics().height() + 6, third = width() / 3;
    const QSize room(third - 16, height() - words - 12);
    if (room.width() < 20 || room.height() < 20)
        return;
    // One scale for all of them; the man stands beside the first.
    const double across = std::max({size.y() + 1.5 * man_m, size.x()});
    const double upwards = std::max({size.z(), size.y(), man_m});
    const double scale = std::min(room.width() / across, room.height() / upwards);
    const double ratio = devicePixelRatioF();
    const QColor body = palette().highlight().color().lighter(130);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side& side = sides[i];
        const QRect place(static_cast<int>(i) * third + 8, 6, room.width(), room.height());
        Sketch sketch(room, ratio, body);
        const double shift = i == 0 ? -0.75 * man_m * scale : 0.0;
        for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
            std::array<osg::Vec3d, 3> p;
            for (std::size_t c = 0; c < 3; ++c) {
                const osg::Vec3d from = corners[k + c] - centre;
                p[c] = {(room.width() * 0.5 + shift + (from * side.right) * scale) * ratio,
                        (room.height() * 0.5 - (from * side.up) * scale) * ratio,
                        from * side.eye / unit_m};
            }
            osg::Vec3d normal = (corners[k + 1] - corners[k]) ^ (corners[k + 2] - corners[k]);
            normal.normalize();
            sketch.add(p, normal * side.eye);
        }
        painter.drawImage(place.topLeft(), sketch.picture());
        painter.setPen(palette().placeholderText().color());
        painter.drawText(QRect(place.left(), place.bottom() + 3, place.width(), words),
                         Qt::AlignHCenter | Qt::AlignTop, side.name);
        if (i > 0)
            continue;
        const double feet = place.top() + room.height() * 0.5 + size.z() * 0.5 * scale,
                     x = place.left() + room.width() * 0.5 + shift +
                         (size.y() * 0.5 + man_m * 0.75) * scale;
        const double tall = man_m * scale;
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette().text());
        if (tall >= 3.0)
            painter.drawPath(manIn({x - tall / 2, feet - tall, tall, tall}));
        painter.setPen(palette().placeholderText().color());
    }
}

} // namespace smat::gui

#include "moc_PlacingPicture.cpp"
