// bench_air [ANSWERS]: what the first answer of an air costs and what further ones do, computed on
// the fly (IrradianceMode 2), from tables that refine themselves (1) and at the points of
// wideband-ck; along one path, between random altitudes and for random lines of sight. An answer is
// transmittance and path radiance of a path, or the background of a line of sight. Processor times,
// the memory is what the further answers leave behind.

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <unistd.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/radiometry/Quadrature.h"

using namespace irsg;

namespace {

double seconds(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double residentMegabytes() {
    long all = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

const SunPosition sun{0.4, 0.7};

/// One way to answer.
struct Way {
    const char* name;
    std::shared_ptr<const AtmosphereSmart> air;
    std::shared_ptr<const SpectralSampling> sampling; ///< set by `prepare`
    std::function<std::shared_ptr<const SpectralSampling>(const AtmosphereSmart&)> prepare;

    void path(const AtmosphericPath& path) const {
        (void)air->provide(AtmosphericQuery::transmittance(path), *sampling);
        (void)air->provide(AtmosphericQuery::pathRadiance(path, sun), *sampling);
    }
    void sky(const LineOfSight& sight) const {
        (void)air->provide(AtmosphericQuery::backgroundRadiance(sight, sun), *sampling);
    }
};

std::shared_ptr<const AtmosphereSmart> atmosphereOf(const Band& band, int irradianceMode) {
    AtmosphereSmartParameters parameters;
    parameters.baseWavelengthMin_um = band.range().min_um;
    parameters.baseWavelengthMax_um = band.range().max_um;
    parameters.irradianceMode = irradianceMode;
    return std::make_shared<const AtmosphereSmart>(parameters);
}

void print(const char* way, const char* what, double first_s, double further_s, int answers,
           double megabytes) {
    std::printf("| %s | %s | %.1f | %.3f | %.1f |\n", way, what, 1e3 * first_s,
                1e3 * further_s / answers, megabytes);
}

void compare(const Band& band, int answers) {
    std::printf("\n%s, %d further answers\n\n", band.name().c_str(), answers);
    std::printf("| way | further answers | first, ms | further, ms each | memory, MB |\n"
                "|---|---|---|---|---|\n");
    const auto nodes = [&band](const AtmosphereSmart& air) { return air.nodesOf({band}); };
    const auto points = [&band](const AtmosphereSmart& air) {
        CkRequest request;
        request.band = band;
        request.sun = sun;
        return std::static_pointer_cast<const SpectralSampling>(air.prepareCk(request));
    };
    for (const auto& [name, mode, prepare] :
         {std::tuple<
              const char*, int,
              std::function<std::shared_ptr<const SpectralSampling>(const AtmosphereSmart&)>>{
              "spectral, on the fly", 2, nodes},
          {"spectral, tables", 1, nodes},
          {"wideband-ck, on the fly", 2, points},
          {"wideband-ck, tables", 1, points}}) {
        const AtmosphericPath begin{3000.0, 300.0, 8000.0};
        const auto ask = [&](const char* what, const std::function<void(const Way&)>& further) {
            Way way{name, nullptr, nullptr, prepare};
            const double first_s = seconds([&] {
                way.air = atmosphereOf(band, mode);
                way.sampling = way.prepare(*way.air);
                way.path(begin);
            });
            const double before = residentMegabytes();
            const double further_s = seconds([&] { further(way); });
            print(name, what, first_s, further_s, answers, residentMegabytes() - before);
        };
        ask("ranges of one line", [&](const Way& way) {
            for (int i = 0; i < answers; ++i)
                way.path({3000.0, 300.0, 8000.0 + 12.0 * i});
        });
        ask("random altitudes", [&](const Way& way) {
            std::mt19937 random(5);
            std::uniform_real_distribution<double> altitude_m(0.0, 12e3);
            for (int i = 0; i < answers; ++i) {
                const double a = altitude_m(random), b = altitude_m(random);
                way.path({a, b, 1.5 * std::abs(a - b) + 2000.0});
            }
        });
        ask("sky of one altitude", [&](const Way& way) {
            std::mt19937 random(6);
            std::uniform_real_distribution<double> elevation_rad(-1.2, 1.2);
            for (int i = 0; i < answers; ++i)
                way.sky({3000.0, elevation_rad(random), 1.0});
        });
    }
}

} // namespace

int main(int count, char** arguments) {
    const int answers = count > 1 ? std::atoi(arguments[1]) : 300;
    GasTable::shipped();         // read once: 30 MB that every way needs
    setenv("SMAT_CACHE", "", 1); // points are trained here, not found
    for (const auto& [low, high] : {std::pair{3.0, 5.0}, {8.0, 12.0}})
        compare(Band::topHat(low, high), answers);
    return 0;
}
