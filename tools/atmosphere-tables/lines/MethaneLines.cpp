#include "tools/atmosphere-tables/lines/MethaneLines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <map>
#include <utility>

#include "tools/atmosphere-tables/lines/AngularMomentum.h"
#include "tools/atmosphere-tables/lines/SymmetricEigen.h"

namespace irsg::lbl {

namespace {

using Complex = std::complex<double>;
constexpr Complex i1{0.0, 1.0};
constexpr double weakest = 1e-25;
constexpr int highestJ = 22;
constexpr double partitionSum296 = 590.5; // TIPS-2017, 12CH4

/// A square matrix of complex numbers.
class Operator {
  public:
    explicit Operator(std::size_t size) : size_(size), values_(size * size) {}
    static Operator identity(std::size_t size) {
        Operator result(size);
        for (std::size_t i = 0; i < size; ++i)
            result(i, i) = 1.0;
        return result;
    }
    std::size_t size() const { return size_; }
    Complex& operator()(std::size_t i, std::size_t j) { return values_[i * size_ + j]; }
    Complex operator()(std::size_t i, std::size_t j) const { return values_[i * size_ + j]; }

    Operator operator*(const Operator& other) const {
        Operator result(size_);
        for (std::size_t i = 0; i < size_; ++i)
            for (std::size_t k = 0; k < size_; ++k)
                if ((*this)(i, k) != 0.0)
                    for (std::size_t j = 0; j < size_; ++j)
                        result(i, j) += (*this)(i, k) * other(k, j);
        return result;
    }
    Operator operator*(Complex factor) const {
        Operator result = *this;
        for (Complex& value : result.values_)
            value *= factor;
        return result;
    }
    Operator operator+(const Operator& other) const {
        Operator result = *this;
        for (std::size_t i = 0; i < values_.size(); ++i)
            result.values_[i] += other.values_[i];
        return result;
    }
    Operator operator-(const Operator& other) const { return *this + other * -1.0; }
    Operator adjoint() const {
        Operator result(size_);
        for (std::size_t i = 0; i < size_; ++i)
            for (std::size_t j = 0; j < size_; ++j)
                result(i, j) = std::conj((*this)(j, i));
        return result;
    }

  private:
    std::size_t size_;
    std::vector<Complex> values_;
};

Operator both(const Operator& a, const Operator& b) {
    return a * b + b * a;
}

using Vector = std::array<Operator, 3>; // x, y, z

/// Jx, Jy, Jz of k = -J to J.
Vector angularMomentum(int J) {
    const auto size = static_cast<std::size_t>(2 * J + 1);
    Operator up(size), z(size);
    for (std::size_t i = 0; i < size; ++i) {
        const int k = static_cast<int>(i) - J;
        z(i, i) = k;
        if (i + 1 < size)
            up(i + 1, i) = std::sqrt(J * (J + 1.0) - k * (k + 1.0));
    }
    const Operator down = up.adjoint();
    return {(up + down) * 0.5, (up - down) * (-0.5 * i1), z};
}

constexpr std::array<std::array<std::size_t, 3>, 3> cycles = {{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}};

/// A sum of products of a vibrational and a rotational operator, as one block of a matrix.
class Sum {
  public:
    Sum(int J, std::vector<std::size_t> places)
        : rotations_(static_cast<std::size_t>(2 * J + 1)),
          places_(std::move(places)),
          matrix_(places_.size()) {}
    void add(double factor, const Operator& vibration, const Operator& rotation) {
        for (std::size_t a = 0; a < places_.size(); ++a)
            for (std::size_t b = 0; b < places_.size(); ++b)
                matrix_(a, b) +=
                    factor * (vibration(places_[a] / rotations_, places_[b] / rotations_) *
                              rotation(places_[a] % rotations_, places_[b] % rotations_))
                                 .real();
    }
    const SquareMatrix& matrix() const { return matrix_; }

  private:
    std::size_t rotations_;
    std::vector<std::size_t> places_;
    SquareMatrix matrix_;
};

/// Vibrational operators of the dyad in the functions |l = -1>, |0>, |1> of nu4 and i |e1>, i |e2>
/// of nu2, e1 like 2 z^2 - x^2 - y^2 and e2 like x^2 - y^2: then all of the Hamiltonian is real.
struct DyadOperators {
    static constexpr std::size_t size = 5;
    Operator nu4{size}, nu2{size}, e1{size}, e2{size};
    Vector l{Operator{size}, Operator{size}, Operator{size}};
    Vector F1{Operator{size}, Operator{size}, Operator{size}};
    Vector F2{Operator{size}, Operator{size}, Operator{size}};

    DyadOperators() {
        const Vector one = angularMomentum(1);
        for (std::size_t i = 0; i < 3; ++i) {
            nu4(i, i) = 1.0;
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t b = 0; b < 3; ++b)
                    l[i](a, b) = one[i](a, b);
        }
        nu2(3, 3) = nu2(4, 4) = 1.0;
        e1(3, 3) = 1.0;
        e1(4, 4) = -1.0;
        e2(3, 4) = e2(4, 3) = 1.0;
        const double h = std::sqrt(0.5), root3 = std::sqrt(3.0);
        const std::array<std::array<Complex, 3>, 3> direction = {
            {{h, 0.0, -h}, {h * i1, 0.0, h * i1}, {0.0, 1.0, 0.0}}};
        auto raise = [&](std::size_t e, std::size_t axis) { // |e> <axis|
            Operator result(size);
            for (std::size_t l0 = 0; l0 < 3; ++l0)
                result(3 + e, l0) = -i1 * std::conj(direction[axis][l0]);
            return result;
        };
        F1 = {raise(1, 0) * -0.5 - raise(0, 0) * (0.5 * root3),
              raise(1, 1) * -0.5 + raise(0, 1) * (0.5 * root3), raise(1, 2)};
        F2 = {raise(0, 0) * -0.5 + raise(1, 0) * (0.5 * root3),
              raise(0, 1) * -0.5 - raise(1, 1) * (0.5 * root3), raise(0, 2)};
    }
};

/// Jx^4 + Jy^4 + Jz^4 without its mean over the levels of J.
Operator quartic(const Vector& J, double N) {
    Operator sum = Operator::identity(J[0].size()) * (-0.6 * N * N + 0.2 * N);
    for (const Operator& part : J) {
        const Operator square = part * part;
        sum = sum + square * square;
    }
    return sum;
}

/// Block 0 to 3: the function is multiplied by exp(-i pi block / 2) by a quarter turn with
/// reflection about z. For every vibrational function, what it adds to k.
std::vector<std::size_t> placesOf(int block, int J, const std::vector<int>& turns) {
    std::vector<std::size_t> places;
    for (std::size_t v = 0; v < turns.size(); ++v)
        for (int k = -J; k <= J; ++k)
            if ((((k + turns[v] - block) % 4) + 4) % 4 == 0)
                places.push_back(v * static_cast<std::size_t>(2 * J + 1) +
                                 static_cast<std::size_t>(J + k));
    return places;
}

/// Levels of a Hamiltonian that `fill(sum)` puts together.
template <class Fill>
std::vector<TetrahedralLevel> levelsOf(int J, const std::vector<int>& turns, Fill&& fill) {
    std::array<std::vector<std::size_t>, 3> places;
    std::array<EigenSystem, 3> systems; // of blocks 0, 2 and 1
    constexpr std::array<int, 3> blocks = {0, 2, 1};
    for (std::size_t b = 0; b < 3; ++b) {
        places[b] = placesOf(blocks[b], J, turns);
        Sum sum(J, places[b]);
        fill(sum);
        systems[b] = eigenSystem(sum.matrix());
    }
    auto isIn = [&](double energy, std::size_t block) {
        return std::ranges::any_of(systems[block].values,
                                   [&](double value) { return std::abs(value - energy) < 1e-7; });
    };
    std::vector<TetrahedralLevel> levels;
    for (const std::size_t b : {std::size_t{0}, std::size_t{1}}) {
        std::map<TetrahedralSpecies, int> count;
        for (std::size_t i = 0; i < systems[b].values.size(); ++i) {
            TetrahedralLevel level;
            level.energy_per_cm = systems[b].values[i];
            level.J = J;
            level.block = blocks[b];
            level.species = isIn(level.energy_per_cm, 1 - b) ? TetrahedralSpecies::E
                            : isIn(level.energy_per_cm, 2)
                                ? (b == 0 ? TetrahedralSpecies::F1 : TetrahedralSpecies::F2)
                                : (b == 0 ? TetrahedralSpecies::A1 : TetrahedralSpecies::A2);
            level.number = ++count[level.species];
            level.amplitudes.assign(turns.size() * static_cast<std::size_t>(2 * J + 1), 0.0);
            for (std::size_t a = 0; a < places[b].size(); ++a)
                level.amplitudes[places[b][a]] = systems[b].vectors[i][a];
            levels.push_back(std::move(level));
        }
    }
    return levels;
}

double spinWeight(TetrahedralSpecies species) {
    switch (species) {
    case TetrahedralSpecies::A1:
    case TetrahedralSpecies::A2:
        return 5.0;
    case TetrahedralSpecies::E:
        return 2.0;
    default:
        return 3.0;
    }
}

/// Mean widths of listed lines by lower J: B J (J + 1) is the lower energy.
class MethaneWidths {
  public:
    explicit MethaneWidths(const std::vector<Line>& listed) {
        for (const Line& line : listed) {
            if (line.isotopologue != 1 || line.lowerEnergy_per_cm > 1500.0)
                continue;
            const int J = static_cast<int>(
                std::lround(std::sqrt(0.25 + line.lowerEnergy_per_cm / 5.2411) - 0.5));
            // A level lies within its centrifugal stretching of that; hot bands do not.
            if (std::abs(line.lowerEnergy_per_cm -
                         J * (J + 1.0) * (5.241 - 1.11e-4 * J * (J + 1))) > 1.0)
                continue;
            Mean& mean = means_[J];
            mean.air += static_cast<double>(line.airWidth_cm_atm);
            mean.self += static_cast<double>(line.selfWidth_cm_atm);
            mean.exponent += static_cast<double>(line.widthExponent);
            mean.count += 1.0;
        }
    }
    void give(Line& line, int J) const {
        line.airShift_cm_atm = -0.0023f; // as of the lines of its P branch
        if (means_.empty())
            return;
        const auto near = means_.lower_bound(J);
        const Mean& mean = near == means_.end() ? means_.rbegin()->second : near->second;
        line.airWidth_cm_atm = static_cast<float>(mean.air / mean.count);
        line.selfWidth_cm_atm = static_cast<float>(mean.self / mean.count);
        line.widthExponent = static_cast<float>(mean.exponent / mean.count);
    }

  private:
    struct Mean {
        double air = 0.0, self = 0.0, exponent = 0.0, count = 0.0;
    };
    std::map<int, Mean> means_;
};

} // namespace

std::vector<TetrahedralLevel> methaneGround(int J) {
    constexpr double B = 5.241038, D = 1.1092752e-4, H = 5.9677668e-9, T = -4.4250548e-5,
                     TJ = 5.0844894e-9;
    const double N = J * (J + 1.0);
    const Vector j = angularMomentum(J);
    const Operator one = Operator::identity(1), still = Operator::identity(j[0].size()),
                   fourth = quartic(j, N);
    return levelsOf(J, {0}, [&](Sum& sum) {
        sum.add(N * (B + N * (-D + N * H)), one, still);
        sum.add(T + N * TJ, one, fourth);
    });
}

std::vector<TetrahedralLevel> methaneDyad(int J) {
    const double N = J * (J + 1.0);
    const Vector j = angularMomentum(J);
    const Operator still = Operator::identity(j[0].size()), fourth = quartic(j, N);
    const DyadOperators v;
    const double root3 = std::sqrt(3.0);
    const Operator z2 = j[2] * j[2], x2 = j[0] * j[0], y2 = j[1] * j[1];

    // Block of a quarter turn with reflection: -exp(-i pi (k + l) / 2) of nu4, exp(-i pi k / 2) of
    // e1 and its opposite of e2.
    return levelsOf(J, {1, 2, 3, 0, 2}, [&](Sum& sum) {
        sum.add(1310.769145 + N * (5.232181776 - 0.0001087001747 * N), v.nu4, still);
        sum.add(-4.436885582e-05, v.nu4, fourth);
        sum.add(1533.340407 + N * (5.245135995 - 0.0001116464 * N), v.nu2, still);
        sum.add(-4.531508818e-05, v.nu2, fourth);
        constexpr double split = 0.002073407035, bent = -0.02311160585;
        sum.add(-2.0 / 3.0 * N * split, v.nu4, still);
        for (const auto& [a, b, c] : cycles) {
            const Operator square = j[a] * j[a], cube = square * j[a];
            sum.add(2.0 * 2.436909659 - 0.0001630472064 * N, v.l[a], j[a]);
            sum.add(-0.0001270874149, v.l[a], cube);
            sum.add(split, v.l[a] * v.l[a], square);
            sum.add(bent, both(v.l[a], v.l[b]), both(j[a], j[b]));
            const Operator turn = v.F1[a] * i1, bend = v.F2[a];
            sum.add(6.049673954 - 0.0007226243177 * N, turn + turn.adjoint(), j[a]);
            sum.add(0.0002660472558, turn + turn.adjoint(), cube);
            sum.add(0.06213069775, bend + bend.adjoint(), both(j[b], j[c]));
        }
        sum.add(0.02644886843, v.e1, z2 - (x2 + y2) * 0.5);
        sum.add(-0.02644886843 * root3 / 2.0, v.e2, x2 - y2);
    });
}

std::vector<Line> methaneDyadLines(const std::vector<Line>& listed, double from_per_cm,
                                   double to_per_cm) {
    // Of nu4, D, times the square root of the abundance, and its change with m, from 739 lines of
    // the P branch at 850 to 1200 cm-1 (ratios to them: 0.3 percent rms for lines above 1e-23).
    constexpr double moment_debye = 0.05782, perRotation = -0.002285;
    constexpr double perDebye2 = 4.16238e-19;
    // 13CH4: nu4 at 1302.781 for 1310.761 cm-1 and nu2 at 1533.493 for 1533.332 (HITRAN), its
    // abundance to that of 12CH4.
    constexpr double heavyMoveNu4_per_cm = 1302.781 - 1310.761,
                     heavyMoveNu2_per_cm = 1533.493 - 1533.332, heavyRatio = 0.0111031 / 0.988274;
    const double c2T = secondRadiationConstant_cm_K / referenceTemperature_K;
    const MethaneWidths widths(listed);
    std::vector<std::vector<TetrahedralLevel>> uppers;
    for (int J = 0; J <= highestJ + 1; ++J)
        uppers.push_back(methaneDyad(J));

    std::vector<Line> lines;
    for (int J = 0; J <= highestJ; ++J) {
        const auto width = static_cast<std::size_t>(2 * J + 1);
        for (const TetrahedralLevel& lower : methaneGround(J)) {
            if (lower.species == TetrahedralSpecies::E && lower.block != 0)
                continue; // its other component
            for (int upperJ = std::max(0, J - 1); upperJ <= J + 1; ++upperJ) {
                const auto upperWidth = static_cast<std::size_t>(2 * upperJ + 1);
                std::vector<double> image(3 * upperWidth, 0.0); // of nu4
                for (int l = -1; l <= 1; ++l)
                    for (int k = -J; k <= J; ++k) {
                        if (std::abs(k - l) > upperJ)
                            continue;
                        image[static_cast<std::size_t>(l + 1) * upperWidth +
                              static_cast<std::size_t>(upperJ + k - l)] +=
                            (l == 0 ? 1.0 : -1.0) * std::sqrt(static_cast<double>(width)) *
                            clebschGordan(J, k, -l, upperJ) *
                            lower.amplitudes[static_cast<std::size_t>(J + k)];
                    }
                const double m = upperJ < J ? -J : upperJ > J ? J + 1.0 : 0.0;
                const double moment = moment_debye * (1.0 + perRotation * m);
                for (const TetrahedralLevel& upper : uppers[static_cast<std::size_t>(upperJ)]) {
                    if (upper.block == lower.block)
                        continue;
                    double sum = 0.0;
                    for (std::size_t i = 0; i < image.size(); ++i)
                        sum += image[i] * upper.amplitudes[i];
                    Line line;
                    line.wavenumber_per_cm = upper.energy_per_cm - lower.energy_per_cm;
                    line.lowerEnergy_per_cm = lower.energy_per_cm;
                    line.intensity = -perDebye2 * line.wavenumber_per_cm / partitionSum296 *
                                     std::expm1(-c2T * line.wavenumber_per_cm) *
                                     std::exp(-c2T * lower.energy_per_cm) *
                                     spinWeight(lower.species) * moment * moment * sum * sum;
                    if (line.intensity < weakest)
                        continue;
                    widths.give(line, J);
                    lines.push_back(line);
                    double nu2 = 0.0; // of the upper level
                    for (std::size_t i = 3 * upperWidth; i < upper.amplitudes.size(); ++i)
                        nu2 += upper.amplitudes[i] * upper.amplitudes[i];
                    line.wavenumber_per_cm +=
                        (1.0 - nu2) * heavyMoveNu4_per_cm + nu2 * heavyMoveNu2_per_cm;
                    line.intensity *= heavyRatio;
                    line.isotopologue = 2;
                    if (line.intensity >= weakest)
                        lines.push_back(line);
                }
            }
        }
    }
    std::erase_if(lines, [&](const Line& line) {
        return line.wavenumber_per_cm < from_per_cm || line.wavenumber_per_cm >= to_per_cm;
    });
    std::ranges::stable_sort(lines, {}, &Line::wavenumber_per_cm);
    return lines;
}

} // namespace irsg::lbl
