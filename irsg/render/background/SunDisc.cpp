#include "irsg/render/background/SunDisc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "irsg/render/background/CircleArea.h"

namespace irsg {

namespace {

/// Discs wider than this many pixels have the solid angle of the sky, to 1e-8.
constexpr double wide_px = 64.0;

/// Coverage that is the rounding of others.
constexpr double negligibleArea = 1e-12;

/// The rim on the image plane: centre, direction and length of its half axes.
struct Ellipse {
    double centreU = 0.0, centreV = 0.0;
    double radialU = 1.0, radialV = 0.0; ///< unit vector away from the middle of the field
    double radial = 0.0, tangential = 0.0;

    PlanePoint onUnitCircle(double u, double v) const {
        const double du = u - centreU, dv = v - centreV;
        return {(du * radialU + dv * radialV) / radial, (dv * radialU - du * radialV) / tangential};
    }
    double reachU() const { return std::hypot(radial * radialU, tangential * radialV); }
    double reachV() const { return std::hypot(radial * radialV, tangential * radialU); }
};

/// A cone of half angle r about s is (s.p)^2 >= cos^2(r) p.p for p = (u, v, 1).
std::optional<Ellipse> rimOf(const FieldRays& rays, const Vec3& towards) {
    const double u = dot(towards, rays.right), v = dot(towards, rays.up);
    const double ahead = dot(towards, rays.forward);
    const double sine = std::sin(0.5 * SunDisc::diameter_rad);
    const double cosine = std::cos(0.5 * SunDisc::diameter_rad);
    if (ahead <= sine)
        return std::nullopt;

    const double depth = (ahead - sine) * (ahead + sine);
    Ellipse rim;
    rim.centreU = u * ahead / depth;
    rim.centreV = v * ahead / depth;
    if (const double off = std::hypot(u, v); off > 0.0)
        rim.radialU = u / off, rim.radialV = v / off;
    rim.radial = sine * cosine / depth;
    rim.tangential = sine / std::sqrt(depth);
    return rim;
}

/// The corners of a pixel, counter-clockwise with v up, as far as they are sky.
class SkyOfPixel {
  public:
    SkyOfPixel(double u, double v, double pitch) {
        const double h = 0.5 * pitch;
        corners_ = {PlanePoint{u - h, v - h}, {u + h, v - h}, {u + h, v + h}, {u - h, v + h}};
        count_ = 4;
    }
    void cut(const Horizon::Line& line, double u, double v) {
        const auto level = [&](const PlanePoint& p) {
            return line.level + (p.x - u) * line.slopeU + (p.y - v) * line.slopeV;
        };
        std::array<PlanePoint, 8> kept;
        std::size_t count = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const PlanePoint &a = corners_[i], &b = corners_[(i + 1) % count_];
            const double atA = level(a), atB = level(b);
            if (atA >= 0.0)
                kept[count++] = a;
            if ((atA >= 0.0) != (atB >= 0.0)) {
                const double t = atA / (atA - atB);
                kept[count++] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
            }
        }
        corners_ = kept;
        count_ = count;
    }
    /// Area of the ellipse inside.
    double areaIn(const Ellipse& rim) const {
        std::array<PlanePoint, 8> mapped;
        for (std::size_t i = 0; i < count_; ++i)
            mapped[i] = rim.onUnitCircle(corners_[i].x, corners_[i].y);
        return areaInUnitCircle({mapped.data(), count_}) * rim.radial * rim.tangential;
    }

  private:
    std::array<PlanePoint, 8> corners_;
    std::size_t count_ = 0;
};

} // namespace

SunDisc::SunDisc(const FieldRays& rays, const Horizon& horizon, const Vec3& towards) {
    const auto rim = rimOf(rays, towards);
    if (!rim)
        return;
    const double pitch = rays.pitch;
    const bool wide = rim->tangential > 0.5 * wide_px * pitch;

    // The pixels of the endless raster that the ellipse may touch; of a wide one, those in the
    // frame.
    const auto column = [&](double u) { return u / pitch + 0.5 * rays.width_px; };
    const auto row = [&](double v) { return 0.5 * rays.height_px - v / pitch; };
    double left = std::floor(column(rim->centreU - rim->reachU()));
    double right = std::ceil(column(rim->centreU + rim->reachU()));
    double top = std::floor(row(rim->centreV + rim->reachV()));
    double bottom = std::ceil(row(rim->centreV - rim->reachV()));
    if (right < 0.0 || left > rays.width_px || bottom < 0.0 || top > rays.height_px)
        return;
    if (wide) {
        left = std::max(left, 0.0), right = std::min(right, 1.0 * rays.width_px);
        top = std::max(top, 0.0), bottom = std::min(bottom, 1.0 * rays.height_px);
    }

    const double pixelReach = std::sqrt(0.5) * pitch / std::min(rim->radial, rim->tangential);
    for (double y = top; y < bottom; ++y)
        for (double x = left; x < right; ++x) {
            const double u = rays.u(x + 0.5), v = rays.v(y + 0.5);
            const PlanePoint middle = rim->onUnitCircle(u, v);
            const double off = std::hypot(middle.x, middle.y);
            if (off >= 1.0 + pixelReach)
                continue;
            SkyOfPixel pixel(u, v, pitch);
            const double area = off + pixelReach <= 1.0 ? pitch * pitch : pixel.areaIn(*rim);
            if (area <= negligibleArea * pitch * pitch)
                continue;
            const double distance = std::sqrt(1.0 + u * u + v * v);
            drawn_sr_ += area / (distance * distance * distance);
            if (x < 0.0 || x >= rays.width_px || y < 0.0 || y >= rays.height_px)
                continue;
            const double sky = horizon.skyFraction(u, v);
            if (sky <= 0.0)
                continue;
            double seen = area;
            if (sky < 1.0) {
                pixel.cut(horizon.lineAt(u, v), u, v);
                seen = pixel.areaIn(*rim);
            }
            if (seen > negligibleArea * pitch * pitch)
                pixels_.push_back({static_cast<int>(x), static_cast<int>(y),
                                   std::min(seen / (pitch * pitch), 1.0)});
        }
    if (wide)
        drawn_sr_ = 2.0 * pi * (1.0 - std::cos(0.5 * diameter_rad));
}

} // namespace irsg
