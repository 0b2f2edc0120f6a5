#include "tests/atmosphere/DiscreteOrdinates.h"

#include <cmath>
#include <numbers>

#include "irsg/radiometry/GaussLegendre.h"

namespace irsg {

namespace {

constexpr std::size_t n = DiscreteOrdinates::half;
constexpr std::size_t moments = 2 * n;
using Row = DiscreteOrdinates::Row;
using Matrix = std::array<Row, n>;

struct Ordinates {
    Row mu, weight;
};

const Ordinates& ordinates() {
    static const Ordinates made = [] {
        const GaussRule& rule = gaussLegendre(n); // over 0 to 1
        Ordinates all{};
        for (std::size_t i = 0; i < n; ++i) {
            all.mu[i] = rule.nodes[i];
            all.weight[i] = rule.weights[i];
        }
        return all;
    }();
    return made;
}

Matrix identity() {
    Matrix one{};
    for (std::size_t i = 0; i < n; ++i) {
        one[i][i] = 1.0;
    }
    return one;
}

Matrix operator*(const Matrix& a, const Matrix& b) {
    Matrix made{};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t j = 0; j < n; ++j) {
                made[i][j] += a[i][k] * b[k][j];
            }
        }
    }
    return made;
}

Row operator*(const Matrix& a, const Row& x) {
    Row made{};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < n; ++k) {
            made[i] += a[i][k] * x[k];
        }
    }
    return made;
}

Matrix operator+(Matrix a, const Matrix& b) {
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            a[i][j] += b[i][j];
        }
    }
    return a;
}

Row operator+(Row a, const Row& b) {
    for (std::size_t i = 0; i < n; ++i) {
        a[i] += b[i];
    }
    return a;
}

Row operator*(double factor, Row a) {
    for (double& value : a) {
        value *= factor;
    }
    return a;
}

/// (1 - a)^-1 by Gauss and Jordan; a is small against 1.
Matrix resolvent(const Matrix& a) {
    Matrix left = identity(), right = identity();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            left[i][j] -= a[i][j];
        }
    }
    for (std::size_t c = 0; c < n; ++c) {
        const double pivot = 1.0 / left[c][c];
        for (std::size_t j = 0; j < n; ++j) {
            left[c][j] *= pivot;
            right[c][j] *= pivot;
        }
        for (std::size_t r = 0; r < n; ++r) {
            const double factor = left[r][c];
            if (r == c || factor == 0.0) {
                continue;
            }
            for (std::size_t j = 0; j < n; ++j) {
                left[r][j] -= factor * left[c][j];
                right[r][j] -= factor * right[c][j];
            }
        }
    }
    return right;
}

/// Sum over l of (2 l + 1) g_l P_l(a) P_l(b), the azimuthal mean of the phase function.
double phase(const std::array<double, moments>& moment, double a, double b) {
    double sum = 0.0, pa = 1.0, pb = 1.0, beforeA = 0.0, beforeB = 0.0;
    for (std::size_t l = 0; l < moments; ++l) {
        const double order = static_cast<double>(l);
        sum += (2.0 * order + 1.0) * moment[l] * pa * pb;
        const double nextA = ((2.0 * order + 1.0) * a * pa - order * beforeA) / (order + 1.0);
        const double nextB = ((2.0 * order + 1.0) * b * pb - order * beforeB) / (order + 1.0);
        beforeA = pa;
        pa = nextA;
        beforeB = pb;
        pb = nextB;
    }
    return sum;
}

/// Moments of the delta-scaled phase function.
std::array<double, moments> momentsOf(double g) {
    const double peak = std::pow(g, static_cast<double>(moments));
    std::array<double, moments> scaled{};
    for (std::size_t l = 0; l < moments; ++l) {
        scaled[l] = (std::pow(g, static_cast<double>(l)) - peak) / (1.0 - peak);
    }
    return scaled;
}

OrdinateLayer deltaScaled(OrdinateLayer layer) {
    const double peak = layer.albedo * std::pow(layer.asymmetry, static_cast<double>(moments));
    layer.opticalDepth *= 1.0 - peak;
    layer.albedo = (layer.albedo - peak) / (1.0 - peak);
    return layer;
}

/// What a layer does to light, and what leaves it: `constant` for a Planck function of 1, `slope`
/// for one that grows by 1 over its depth from -1/2 at the top (upwards; downwards the negative),
/// `litUp` and `litDown` for a beam of 1 at its top.
struct Operators {
    Matrix reflection{}, transmission{};
    Row constant{}, slope{}, litUp{}, litDown{};
};

Operators doubled(const OrdinateLayer& layer, double beamCosine) {
    const Ordinates& at = ordinates();
    const std::array<double, moments> moment = momentsOf(layer.asymmetry);
    // Of a layer so thin that light is scattered once or not at all.
    constexpr double thin = 2e-8;
    const int doublings = layer.opticalDepth > thin
                              ? static_cast<int>(std::ceil(std::log2(layer.opticalDepth / thin)))
                              : 0;
    double depth = std::ldexp(layer.opticalDepth, -doublings);
    Operators own;
    for (std::size_t i = 0; i < n; ++i) {
        const double length = depth / at.mu[i];
        for (std::size_t j = 0; j < n; ++j) {
            const double scattering = 0.5 * layer.albedo * at.weight[j] * length;
            own.reflection[i][j] = scattering * phase(moment, at.mu[i], -at.mu[j]);
            own.transmission[i][j] =
                scattering * phase(moment, at.mu[i], at.mu[j]) + (i == j ? 1.0 - length : 0.0);
        }
        own.constant[i] = length * (1.0 - layer.albedo);
        const double lit = 0.25 * std::numbers::inv_pi * layer.albedo * length;
        own.litUp[i] = lit * phase(moment, at.mu[i], -beamCosine);
        own.litDown[i] = lit * phase(moment, at.mu[i], beamCosine);
    }
    for (int k = 0; k < doublings; ++k) {
        const Matrix inside = resolvent(own.reflection * own.reflection);
        const double passed = std::exp(-depth / beamCosine);
        const Operators half = own;
        own.reflection =
            half.reflection + half.transmission * inside * half.reflection * half.transmission;
        own.transmission = half.transmission * inside * half.transmission;
        own.constant =
            half.constant +
            half.transmission * (inside * (half.constant + half.reflection * half.constant));
        // In units of the whole: each half has half of the slope, about -1/4 and +1/4.
        const Row bottomUp = 0.5 * half.slope + 0.25 * half.constant;
        const Row topUp = 0.5 * half.slope + -0.25 * half.constant;
        const Row topDown = -1.0 * bottomUp; // as the layer upside down
        own.slope = topUp + half.transmission * (inside * (bottomUp + half.reflection * topDown));
        own.litUp =
            half.litUp +
            half.transmission * (inside * (passed * half.litUp + half.reflection * half.litDown));
        own.litDown =
            passed * half.litDown +
            half.transmission * (inside * (half.litDown + half.reflection * (passed * half.litUp)));
        depth *= 2.0;
    }
    return own;
}

} // namespace

DiscreteOrdinates::DiscreteOrdinates(std::vector<OrdinateLayer> layers, double groundAlbedo,
                                     double groundPlanck, double beam, double sinElevation)
    : layers_(std::move(layers)) {
    const Ordinates& at = ordinates();
    for (OrdinateLayer& layer : layers_) {
        layer = deltaScaled(layer);
    }
    const std::size_t count = layers_.size();
    std::vector<double> beams(count + 1, beam); // at every level, normal to itself
    for (std::size_t k = count; k-- > 0;) {
        beams[k] = beams[k + 1] * std::exp(-layers_[k].opticalDepth / sinElevation);
    }

    // From the ground up: what reflects below a level, and what leaves it upwards.
    std::vector<Operators> own;
    std::vector<Matrix> below(count + 1);
    std::vector<Row> leaving(count + 1), upwards(count), downwards(count);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            below[0][i][j] = 2.0 * groundAlbedo * at.mu[j] * at.weight[j];
        }
        leaving[0][i] = (1.0 - groundAlbedo) * groundPlanck +
                        groundAlbedo * std::numbers::inv_pi * sinElevation * beams[0];
    }
    for (std::size_t k = 0; k < count; ++k) {
        own.push_back(doubled(layers_[k], sinElevation));
        const Operators& layer = own.back();
        const double middle = 0.5 * (layers_[k].planckBelow + layers_[k].planckAbove);
        const double growth = layers_[k].planckBelow - layers_[k].planckAbove; // downwards
        upwards[k] = middle * layer.constant + growth * layer.slope + beams[k + 1] * layer.litUp;
        downwards[k] =
            middle * layer.constant + -growth * layer.slope + beams[k + 1] * layer.litDown;
        const Matrix inside = resolvent(below[k] * layer.reflection);
        below[k + 1] =
            layer.reflection + layer.transmission * inside * below[k] * layer.transmission;
        leaving[k + 1] =
            upwards[k] + layer.transmission * (inside * (leaving[k] + below[k] * downwards[k]));
    }
    // And down again, from space.
    up_.resize(count + 1);
    down_.resize(count + 1);
    up_[count] = leaving[count];
    for (std::size_t k = count; k-- > 0;) {
        const Matrix inside = resolvent(own[k].reflection * below[k]);
        down_[k] = inside * (own[k].transmission * down_[k + 1] + downwards[k] +
                             own[k].reflection * leaving[k]);
        up_[k] = leaving[k] + below[k] * down_[k];
    }
    for (std::size_t level = 0; level <= count; ++level) {
        double upFlux = 0.0, downFlux = 0.0, sum = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            upFlux += 2.0 * std::numbers::pi * at.weight[i] * at.mu[i] * up_[level][i];
            downFlux += 2.0 * std::numbers::pi * at.weight[i] * at.mu[i] * down_[level][i];
            sum += 0.5 * at.weight[i] * (up_[level][i] + down_[level][i]);
        }
        up.push_back(upFlux);
        down.push_back(downFlux);
        mean.push_back(sum);
    }
}

double DiscreteOrdinates::scattered(std::size_t level, double cosine) const {
    const Ordinates& at = ordinates();
    const std::array<double, moments> moment =
        momentsOf(layers_[level > 0 ? level - 1 : 0].asymmetry);
    double sum = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
        sum += 0.5 * at.weight[j] *
               (phase(moment, cosine, at.mu[j]) * up_[level][j] +
                phase(moment, cosine, -at.mu[j]) * down_[level][j]);
    }
    return sum;
}

} // namespace irsg
