// The haze of one object, beside the way of the report's section 9: the full frame padded to a
// square, complex transforms in double precision that are planned at every call, two shifts and a
// modulus. Ratios are taken in alternation; each is a median.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdio>
#include <functional>
#include <memory>
#include <vector>

#include <fftw3.h>

#include "irsg/scattering/MtfFilter.h"
#include "tests/scattering/KnownHaze.h"

namespace {

using namespace irsg;
using Complex = std::complex<double>;

double seconds(const std::function<void()>& work) {
    const auto begun = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Swaps the quadrants.
void shift(std::vector<Complex>& values, int size) {
    const int half = size / 2;
    for (int y = 0; y < half; ++y)
        for (int x = 0; x < size; ++x)
            std::swap(values[static_cast<std::size_t>(y * size + x)],
                      values[static_cast<std::size_t>((y + half) * size + (x + half) % size)]);
}

/// One call of the report's ApplyMTF: frame in, frame out.
void reportsConfiguration(const std::vector<float>& frame, const std::vector<double>& mtf, int size,
                          std::vector<float>& out) {
    std::vector<Complex> values(frame.begin(), frame.end()), spectrum(values.size());
    const auto raw = [](std::vector<Complex>& v) {
        return reinterpret_cast<fftw_complex*>(v.data());
    };
    fftw_plan plan =
        fftw_plan_dft_2d(size, size, raw(values), raw(spectrum), FFTW_FORWARD, FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    shift(spectrum, size);
    for (std::size_t i = 0; i < spectrum.size(); ++i)
        spectrum[i] *= mtf[i];
    shift(spectrum, size);
    plan = fftw_plan_dft_2d(size, size, raw(spectrum), raw(values), FFTW_BACKWARD, FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    for (std::size_t i = 0; i < values.size(); ++i)
        out[i] = static_cast<float>(std::abs(values[i]) / static_cast<double>(values.size()));
}

void compare(int size, int object, int support) {
    const MtfCurve curve = KnownHaze{30.0, 1.5}.curve();
    MtfFilter filter(std::make_shared<const PixelHaze>(HazeFunction(curve), 1e-3, support));
    const int corner = (size - object) / 2;
    const HazeWindow window{corner, corner, object, object};
    const HazeWindow to = window.grown(support, size, size);
    const std::vector<float> values(window.size(), 1.0f);
    std::vector<float> sums(to.size(), 0.0f);

    const auto count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    std::vector<float> frame(count, 0.0f), out(count);
    for (int y = 0; y < object; ++y)
        std::fill_n(&frame[static_cast<std::size_t>((corner + y) * size + corner)], object, 1.0f);
    std::vector<double> mtf;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            mtf.push_back(curve.at(std::hypot(x - size / 2, y - size / 2) / (size * 1e-3)));

    filter.addHaze(window, values, to, sums); // plans, and transforms the haze
    std::vector<double> ours, reports;
    for (int i = 0; i < 21; ++i) {
        ours.push_back(seconds([&] { filter.addHaze(window, values, to, sums); }));
        reports.push_back(seconds([&] { reportsConfiguration(frame, mtf, size, out); }));
    }
    std::printf("%5d %7d %8d %12zu %10.3f %10.3f %8.1f\n", size, object, support,
                filter.points(window, to), 1e3 * median(ours), 1e3 * median(reports),
                median(reports) / median(ours));
}

} // namespace

int main() {
    std::printf("Time per object and frame, ms\n%5s %7s %8s %12s %10s %10s %8s\n", "frame",
                "object", "support", "points", "ours", "report's", "ratio");
    for (const int support : {64, 128, 256, 512})
        compare(512, 64, support);
    compare(1024, 64, 64);
    compare(1024, 64, 1024);
}
