#include "irsg/scene/Outputs.h"

namespace irsg {

Outputs Outputs::image() {
    Outputs made;
    made.image_ = true;
    return made;
}

Outputs Outputs::background() {
    Outputs made = image();
    made.objects_ = false;
    return made;
}

Outputs::ImageWithReports Outputs::imageWithReports() {
    Outputs made = image();
    made.reports_ = true;
    return ImageWithReports(std::move(made));
}

Outputs Outputs::followedImage() {
    Outputs made = image();
    made.followed_ = true;
    return made;
}

Outputs::Reports Outputs::reports(std::vector<Band> bands) {
    Outputs made;
    made.reports_ = true;
    made.bands_ = std::move(bands);
    return Reports(std::move(made));
}

Outputs::OfSpectrum Outputs::spectrum(std::vector<double> wavenumbers_per_cm) {
    Outputs made;
    made.wavenumbers_per_cm_ = std::move(wavenumbers_per_cm);
    return OfSpectrum(std::move(made));
}

Outputs::OfScales Outputs::scaledView(std::vector<ScalingInput> scalings, std::vector<Band> bands) {
    Outputs made;
    made.scalings_ = std::move(scalings);
    made.bands_ = std::move(bands);
    return OfScales(std::move(made));
}

Outputs Outputs::scaledSpectrum(std::vector<ScalingInput> scalings,
                                std::vector<double> wavenumbers_per_cm) {
    Outputs made;
    made.scalings_ = std::move(scalings);
    made.wavenumbers_per_cm_ = std::move(wavenumbers_per_cm);
    return made;
}

} // namespace irsg
