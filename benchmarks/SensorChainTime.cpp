// bench_sensor: processor time of the steps from radiance above the pixel grid to counts, for the
// sensors named on the command line (.smatsensor) at 1 and 16 samples per pixel; before the sum
// what only the first frame needs, the transforms of the point spread.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "irsg/sensor/SensorChain.h"
#include "irsg/sensor/SensorFile.h"

namespace {

/// The least of five.
template <typename Work>
double processor_ms(const Work& work) {
    double least_ms = 1e30;
    for (int i = 0; i < 5; ++i) {
        const std::clock_t begun = std::clock();
        work();
        least_ms = std::min(least_ms, 1e3 * static_cast<double>(std::clock() - begun) /
                                          static_cast<double>(CLOCKS_PER_SEC));
    }
    return least_ms;
}

} // namespace

int main(int argc, char** argv) {
    using namespace irsg;
    if (argc < 2)
        std::puts("usage: bench_sensor FILE.smatsensor ...");
    for (int i = 1; i < argc; ++i) {
        const SensorChain chain(loadSensor(argv[i]));
        const SensorDetector& detector = chain.sensor().detector;
        std::printf("%s, %d x %d\n", argv[i], detector.columns, detector.rows);
        const double level =
            chain.response().signal(300.0).scene / chain.response().signalPerRadiance();
        for (const int samples : {1, 4}) {
            std::vector<float> radiance(static_cast<std::size_t>(detector.columns * samples) *
                                        static_cast<std::size_t>(detector.rows * samples));
            for (std::size_t at = 0; at < radiance.size(); ++at)
                radiance[at] = static_cast<float>(
                    level * (1.0 + 0.01 * std::sin(1e-3 * static_cast<double>(at % 7919))));
            std::vector<double> signal;
            const double once_ms = processor_ms([&] {
                const SensorBlur blur(chain.pointSpread(),
                                      static_cast<std::size_t>(detector.columns),
                                      static_cast<std::size_t>(detector.rows), samples);
                return blur.samples();
            });
            (void)chain.exposed(radiance, samples);
            const double blur_ms = processor_ms([&] { signal = chain.exposed(radiance, samples); });
            double sum = 0.0;
            const double noise_ms = processor_ms([&] { sum += chain.noisy(signal, 1, 0).front(); });
            const double read_ms =
                processor_ms([&] { sum += chain.read(signal, 1, 0).counts.front(); });
            std::printf("  %2d samples: blur %.1f ms, noise and counts %.1f ms (noise %.1f), sum "
                        "%.1f ms; once %.1f ms; %g\n",
                        samples * samples, blur_ms, read_ms, noise_ms, blur_ms + read_ms, once_ms,
                        sum);
        }
    }
}
