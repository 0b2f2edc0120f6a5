#include "gui/view/SensorFrusta.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/view/InfraredDisplay.h"

namespace smat::gui {

namespace {

/// Whoever looks around from elsewhere changes nothing of the sensor's picture.
bool isSame(const InfraredRequest& a, const InfraredRequest& b) {
    return a.project == b.project && a.settings == b.settings && a.edited == b.edited &&
           a.models == b.models && a.camera == b.camera && a.targetYaw_rad == b.targetYaw_rad &&
           a.size_px == b.size_px && a.horizontalFieldOfView_rad == b.horizontalFieldOfView_rad;
}

} // namespace

SensorFrusta::SensorFrusta(std::function<std::optional<InfraredRequest>()> sensor, QObject* parent)
    : QObject(parent), sensor_(std::move(sensor)) {}

SensorFrusta::~SensorFrusta() {
    delete display_;
}

void SensorFrusta::setOn(bool on) {
    if (on == isOn())
        return;
    if (!on) {
        delete std::exchange(display_, nullptr);
        windows_.clear();
        picture_.reset();
        asked_.reset();
        emit changed();
        return;
    }
    display_ = new InfraredDisplay(this);
    connect(display_, &InfraredDisplay::drawn, this, [this](const InfraredPicture& picture) {
        windows_ = irsg::tilesOf(*picture.image);
        picture_ = picture;
        picture_->image = nullptr;
        picture_->colors = {};
        emit changed();
    });
    // Why there is no picture is told by the display that wants to show one.
    connect(display_, &InfraredDisplay::failed, this, [this] {
        windows_.clear();
        picture_.reset();
        emit changed();
    });
    ask();
}

void SensorFrusta::outdate() {
    if (isOn())
        ask();
}

void SensorFrusta::ask() {
    std::optional<InfraredRequest> request = sensor_();
    if (!request || (asked_ && isSame(*asked_, *request)))
        return;
    request->map = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
    request->revision = ++revision_;
    asked_ = request;
    display_->ask(*std::move(request));
}

bool SensorFrusta::isUpToDate() const {
    return display_ == nullptr || !display_->isBusy();
}

std::vector<ViewFrustum> SensorFrusta::frusta(const irsg::Vec3& target_m) const {
    if (!picture_)
        return {};
    const irsg::Viewpoint& eye = picture_->eye;
    const double width = picture_->size_px.width(), height = picture_->size_px.height();
    const double depth_m = std::max(irsg::dot(target_m - eye.position_m, eye.forward()), 1e-3);
    const double metresPerPixel =
        2.0 * depth_m * std::tan(0.5 * picture_->horizontalFieldOfView_rad) / width;
    const irsg::Vec3 middle = eye.position_m + eye.forward() * depth_m;
    const auto place = [&](double x_px, double y_px) {
        return middle + eye.right * ((x_px - 0.5 * width) * metresPerPixel) +
               eye.up * ((0.5 * height - y_px) * metresPerPixel);
    };
    std::vector<ViewFrustum> frusta;
    const auto add = [&](ViewFrustum::Of of, double left, double top, double r, double bottom) {
        frusta.push_back(
            {of,
             eye.position_m,
             {place(left, top), place(r, top), place(r, bottom), place(left, bottom)}});
    };
    add(ViewFrustum::Of::frame, 0.0, 0.0, width, height);
    for (const irsg::SampledTile& window : windows_)
        add(window.across > 0.0 ? ViewFrustum::Of::window : ViewFrustum::Of::point, window.left_px,
            window.top_px, window.right_px, window.bottom_px);
    return frusta;
}

} // namespace smat::gui

#include "moc_SensorFrusta.cpp"
