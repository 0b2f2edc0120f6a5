// Inter-reflection of bodies that turn, and of bodies that are far from each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "irsg/radiance/exchange/LightSolution.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/PreparedEntities.h"
#include "tests/support/RaysTest.h"
#include "tests/support/RevolvedMeshes.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class TurnedBodies : public RaysTest {};

double skyFactor(double cosine) {
    return 0.5 * (1.0 + cosine);
}

/// `parts`: how many times fewer cells, nodes and senders it has than a body as a rule.
std::shared_ptr<const BodyLight>
madeBody(const PieceUses& uses, const std::shared_ptr<const RayMesh>& rays, std::size_t parts = 1) {
    ExchangeResolution resolution;
    resolution.isAlone = true;
    resolution.fewCells /= parts;
    resolution.fewNodes /= parts;
    resolution.fewSenders /= parts;
    return std::make_shared<const BodyLight>(
        std::make_shared<const ExchangeNodes>(
            std::make_shared<const ExchangeMesh>(rays, uses, resolution), resolution),
        uses, 0.01);
}

constexpr std::size_t fewer = 10; ///< parts, where light is solved to its end

/// A ball between two discs, over a pane.
struct SampleBody {
    explicit SampleBody(std::size_t parts = 1) {
        Triangles all = disc(1.0, 0.0, {1, 1});
        for (const Triangles& more : {moved(sphereOfEqualArea(0.3, 12, {2, 2}), {0.2, 0.1, 0.6}),
                                      disc(0.5, 1.2, {3, 3}, false), disc(0.25, 0.2, {4, 4})}) {
            all.insert(all.end(), more.begin(), more.end());
        }
        mesh = modelOf(all)->mesh();
        rays = RayMesh::of(mesh);
        uses = PieceUses(mesh->pieces.size());
        for (std::size_t i = 0; i < mesh->pieces.size(); ++i) {
            const int code = mesh->partOf(mesh->pieces[i]).codes.material;
            uses.set(i, {true, code == 4, false, 0, code == 4 ? code + 1 : 0});
            materials.push_back(code);
        }
        light = madeBody(uses, rays, parts);
    }
    SunShadows::Caster at(int entity, const Vec3& where_m, double yaw_rad, int firstRow) const {
        SunShadows::Caster caster{entity, rays, Pose{}, uses, {}, materials};
        caster.pose.position_m = where_m;
        caster.pose.attitude.yaw_rad = yaw_rad;
        caster.pose.attitude.roll_rad = 0.4 * yaw_rad;
        for (std::size_t i = 0; i < materials.size(); ++i) {
            caster.rows.push_back(firstRow + static_cast<int>(i));
        }
        return caster;
    }

    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const RayMesh> rays;
    PieceUses uses{0};
    std::vector<int> materials;
    std::shared_ptr<const BodyLight> light;
};

LightExchange exchangeOf(const std::vector<SunShadows::Caster>& casters,
                         const std::vector<std::shared_ptr<const BodyLight>>& lights,
                         bool hasLobes = false) {
    LightSources sources;
    sources.towardsSun = normalized(Vec3{0.3, -0.2, 0.8});
    sources.skyOf = skyFactor;
    std::vector<LightExchange::Body> bodies;
    for (std::size_t b = 0; b < casters.size(); ++b) {
        LightExchange::Extent extent{casters[b].pose.position_m, 1.6, 2.0, {1.0}};
        bodies.push_back({casters[b].entity, lights[b], extent});
    }
    return LightExchange(std::move(bodies), casters, sources, 0.01, hasLobes);
}

/// All that knows where a body turns, of receivers and senders from some on.
std::vector<double> numbersOf(const LightExchange& exchange, std::size_t firstReceiver,
                              std::size_t receivers, std::size_t firstSender, std::size_t senders,
                              int rowsBefore) {
    std::vector<double> all;
    const auto addPairs = [&](const LightPairs& pairs, std::size_t first, std::size_t count,
                              std::size_t sendersBefore) {
        for (std::size_t r = first; r < first + count; ++r) {
            const auto [begin, end] = pairs.of(r);
            for (const LightPair* pair = begin; pair != end; ++pair) {
                all.push_back(static_cast<double>(pair->sender - sendersBefore));
                all.push_back(static_cast<double>(pair->factor));
            }
        }
    };
    addPairs(exchange.pairs(), firstReceiver, receivers, firstSender);
    addPairs(exchange.between(), firstSender, senders, firstSender);
    for (std::size_t r = firstReceiver; r < firstReceiver + receivers; ++r) {
        all.push_back(exchange.loss(r).sky);
        all.push_back(exchange.loss(r).ground);
    }
    for (std::size_t s = firstSender; s < firstSender + senders; ++s) {
        all.push_back(exchange.sky(s));
        all.push_back(exchange.ground(s));
        all.push_back(exchange.sun(s));
    }
    for (std::size_t r = firstReceiver; r < firstReceiver + receivers; ++r) {
        const auto [begin, end] = exchange.sunBesideMean().of(r);
        for (const LightPair* pair = begin; pair != end; ++pair) {
            all.push_back(static_cast<double>(pair->sender % exchange.rows()) - rowsBefore);
            all.push_back(static_cast<double>(pair->factor));
        }
    }
    return all;
}

std::vector<double> numbersOf(const LightExchange& exchange) {
    return numbersOf(exchange, 0, exchange.receivers(), 0, exchange.senders(), 0);
}

} // namespace

TEST_F(TurnedBodies, HaveTheSameNumbersFromWhatIsKeptOfThem) {
    const SampleBody body;
    for (const double yaw_rad : {0.0, 0.7, 2.5}) {
        const SunShadows::Caster caster = body.at(0, {0, 0, 500}, yaw_rad, 0);
        // One that nobody has turned yet beside one that was turned twice and more.
        const auto fresh = madeBody(body.uses, body.rays);
        const std::vector<double> once = numbersOf(exchangeOf({caster}, {fresh}));
        for (int i = 0; i < 2; ++i) {
            EXPECT_EQ(numbersOf(exchangeOf({caster}, {body.light})), once) << yaw_rad;
        }
        EXPECT_GT(once.size(), 1000u);
    }
}

TEST_F(TurnedBodies, AreReadAsTheyWereWritten) {
    const SampleBody body;
    const std::string bytes = body.light->written();
    EXPECT_GT(body.light->passages().size(), 1u) << "what is seen through the pane";
    for (const double yaw_rad : {0.0, 0.7}) {
        const SunShadows::Caster caster = body.at(0, {0, 0, 500}, yaw_rad, 0);
        const auto read = BodyLight::read(body.rays, bytes);
        ASSERT_NE(read, nullptr);
        for (int i = 0; i < 3; ++i) { // the second time with what is kept of it
            EXPECT_EQ(numbersOf(exchangeOf({caster}, {read})),
                      numbersOf(exchangeOf({caster}, {body.light})))
                << yaw_rad;
        }
        EXPECT_TRUE(read->written() == bytes);
        EXPECT_EQ(read->error(), body.light->error());
    }
    for (std::size_t part = 1; part < 64; ++part) {
        EXPECT_EQ(BodyLight::read(body.rays, bytes.substr(0, bytes.size() * part / 64)), nullptr)
            << part;
    }
    EXPECT_EQ(BodyLight::read(body.rays, bytes + "x"), nullptr);
    EXPECT_EQ(BodyLight::read(RayMesh::of(modelOf(disc(1.0, 0.0, {1, 1}))->mesh()), bytes),
              nullptr);
}

TEST_F(TurnedBodies, AreKeptOnDiskByAllThatTheyDependOn) {
    const smat::test::TemporaryFolder folder;
    setenv("SMAT_CACHE", folder.path().c_str(), 1);
    const auto kept = [&] {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
            count += entry.is_regular_file() ? 1 : 0;
        }
        return count;
    };
    const auto bytesOf = [](double radius_m, double error, BodyPlace place, bool cullsBackFaces) {
        Triangles all = disc(radius_m, 0.0, {1, 1});
        const Triangles over = disc(0.5, 0.4, {2, 2}, false);
        all.insert(all.end(), over.begin(), over.end());
        PreparedModel model{.model = modelOf(all)};
        PieceUses uses(model.mesh().pieces.size());
        for (std::size_t i = 0; i < model.mesh().pieces.size(); ++i) {
            uses.set(i, {true, false, cullsBackFaces, 0, 0});
        }
        return model.lightBetween(uses, error, place)->written();
    };
    const std::string first = bytesOf(1.0, 0.01, BodyPlace::alone, false);
    EXPECT_EQ(kept(), 1u);
    EXPECT_TRUE(bytesOf(1.0, 0.01, BodyPlace::alone, false) == first);
    EXPECT_EQ(kept(), 1u);
    bytesOf(static_cast<double>(std::nextafter(1.0f, 2.0f)), 0.01, BodyPlace::alone, false);
    bytesOf(1.0, 0.02, BodyPlace::alone, false);
    bytesOf(1.0, 0.01, BodyPlace::overTerrain, false);
    bytesOf(1.0, 0.01, BodyPlace::alone, true);
    EXPECT_EQ(kept(), 5u);

    // What is damaged is made anew, and what nobody may keep is made as well.
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
        if (entry.is_regular_file()) {
            std::filesystem::resize_file(entry.path(), entry.file_size() - 1);
        }
    }
    EXPECT_TRUE(bytesOf(1.0, 0.01, BodyPlace::alone, false) == first);
    EXPECT_TRUE(bytesOf(1.0, 0.01, BodyPlace::alone, false) == first);
    setenv("SMAT_CACHE", "", 1);
    EXPECT_TRUE(bytesOf(1.0, 0.01, BodyPlace::alone, false) == first);
    EXPECT_EQ(kept(), 5u);
}

TEST_F(TurnedBodies, LoseSkyAndGroundAsTheyTurn) {
    const SampleBody body;
    const LightExchange level = exchangeOf({body.at(0, {0, 0, 500}, 0.0, 0)}, {body.light});
    const LightExchange over = exchangeOf({body.at(0, {0, 0, 500}, 2.5 * pi, 0)}, {body.light});
    double sky = 0.0, ground = 0.0, whole = 0.0, overSky = 0.0, overGround = 0.0;
    double lost_m2 = 0.0, whole_m2 = 0.0;
    for (std::uint32_t r = 0; r < level.receivers(); ++r) {
        sky += level.loss(r).sky;
        ground += level.loss(r).ground;
        overSky += over.loss(r).sky;
        overGround += over.loss(r).ground;
        whole += level.seen(r);
        const double area_m2 = body.light->nodes().areaOf_m2(r);
        lost_m2 += area_m2 * (level.loss(r).sky + level.loss(r).ground);
        whole_m2 += area_m2 * level.seen(r);
    }
    // What is before a surface is before it however the body turns; a roll by half a turn makes
    // ground of sky.
    EXPECT_NEAR(lost_m2, whole_m2, 1e-4 * whole_m2);
    EXPECT_NEAR(overSky, ground, 2e-3 * whole);
    EXPECT_NEAR(overGround, sky, 2e-3 * whole);
    EXPECT_GT(std::abs(sky - ground), 0.02 * whole);
}

TEST_F(TurnedBodies, FarFromEachOtherAreAsEachAlone) {
    const SampleBody body, other;
    const auto rows = static_cast<int>(body.materials.size());
    const SunShadows::Caster near = body.at(0, {0, 0, 500}, 0.7, 0);
    const SunShadows::Caster far = other.at(1, {400, 300, 700}, 1.9, rows);
    const LightExchange first = exchangeOf({near}, {body.light});
    const LightExchange second =
        exchangeOf({other.at(1, far.pose.position_m, 1.9, 0)}, {other.light});
    const LightExchange both = exchangeOf({near, far}, {body.light, other.light});
    ASSERT_TRUE(both.areApart());
    ASSERT_EQ(both.receivers(), first.receivers() + second.receivers());
    EXPECT_EQ(numbersOf(both, 0, first.receivers(), 0, first.senders(), 0), numbersOf(first));
    EXPECT_EQ(numbersOf(both, first.receivers(), second.receivers(), first.senders(),
                        second.senders(), rows),
              numbersOf(second));
    // One that stands beside them changes none of the far one.
    const SunShadows::Caster beside = body.at(2, {3, 0, 500}, 0.7, 2 * rows);
    const LightExchange three =
        exchangeOf({near, far, beside}, {body.light, other.light, body.light});
    EXPECT_FALSE(three.areApart());
    EXPECT_EQ(numbersOf(three, first.receivers(), second.receivers(), first.senders(),
                        second.senders(), rows),
              numbersOf(second));
}

TEST_F(TurnedBodies, FarFromEachOtherAreSolvedAsEachAlone) {
    const SampleBody body(fewer), other(fewer);
    const auto rows = static_cast<int>(body.materials.size());
    const auto columnsOf = [&](int firstRow) {
        std::vector<LightColumn> columns;
        for (int row = 0; row < rows; ++row) {
            for (const LightPattern pattern :
                 {LightPattern::emission, LightPattern::sky, LightPattern::sun}) {
                columns.push_back({firstRow + row, 0, pattern});
            }
        }
        return columns;
    };
    const auto knotOf = [](const LightExchange& exchange) {
        return LightKnot{std::vector<double>(exchange.rows(), 0.6),
                         std::vector<double>(exchange.panes().size(), 0.5),
                         {}};
    };
    const SunShadows::Caster near = body.at(0, {0, 0, 500}, 0.7, 0);
    const SunShadows::Caster far = other.at(1, {400, 300, 700}, 1.9, rows);
    const LightExchange one = exchangeOf({near}, {body.light});
    const LightExchange both = exchangeOf({near, far}, {body.light, other.light});
    std::vector<LightColumn> columns = columnsOf(0), more = columnsOf(rows);
    const LightSolution alone(one, columns, {knotOf(one)}, -1, 1e-7);
    columns.insert(columns.end(), more.begin(), more.end());
    const LightSolution together(both, columns, {knotOf(both)}, -1, 1e-7);
    double most = 0.0;
    for (std::size_t r = 0; r < one.receivers(); ++r) {
        const std::span<const float> own = alone.of(r), all = together.of(r);
        ASSERT_EQ(own.empty(), all.empty());
        for (std::size_t c = 0; c < own.size(); ++c) {
            EXPECT_NEAR(all[c], own[c], 2e-6) << r << ' ' << c;
            most = std::max(most, static_cast<double>(own[c]));
        }
        for (std::size_t c = own.size(); c < all.size(); ++c) {
            EXPECT_EQ(all[c], 0.0f);
        }
    }
    EXPECT_GT(most, 0.1);
}

TEST_F(TurnedBodies, FarFromEachOtherArePutTogetherOfEachAlone) {
    const SampleBody body(fewer), other(fewer);
    const auto rows = static_cast<int>(body.materials.size());
    const SunShadows::Caster near = body.at(0, {0, 0, 500}, 0.7, 0);
    const SunShadows::Caster far = other.at(1, {400, 300, 700}, 1.9, rows);
    const auto both = std::make_shared<const LightExchange>(
        exchangeOf({near, far}, {body.light, other.light}, true));
    const auto together = std::make_shared<const LightExchange>(
        std::vector{std::make_shared<const LightExchange>(exchangeOf({near}, {body.light}, true)),
                    std::make_shared<const LightExchange>(exchangeOf({far}, {other.light}, true))},
        std::vector{near, far}, true);
    ASSERT_EQ(together->alone().size(), 2u);
    EXPECT_TRUE(together->areApart());
    EXPECT_EQ(numbersOf(*together), numbersOf(*both));
    ASSERT_EQ(together->panes(), both->panes());
    ASSERT_EQ(together->through().size(), both->through().size());
    ASSERT_GE(both->through().size(), 2u) << "what is seen through the pane of each";
    ASSERT_EQ(together->reflected(), both->reflected());
    for (std::size_t row = 0; row < both->rows(); ++row) {
        EXPECT_EQ(together->seesAnything(static_cast<int>(row)),
                  both->seesAnything(static_cast<int>(row)));
    }
    std::uint32_t cells = 0;
    for (const LightExchange::Body& one : both->bodies()) {
        cells += static_cast<std::uint32_t>(one.light->mesh().cells());
    }
    double sunBeside = 0.0;
    for (std::uint32_t cell = 0; cell < cells; ++cell) {
        EXPECT_EQ(together->openAt(cell), both->openAt(cell));
        const auto leaving = [&](const LightExchange& exchange) {
            std::vector<double> all; // of sets of panes in any order
            exchange.forEachReflected(cell, 0.2f, 0.3f, [&](std::uint32_t number, float weight) {
                all.push_back(static_cast<double>(weight));
                all.push_back(number < exchange.senders() + exchange.rows() ? number : 0.0);
                sunBeside += number < exchange.senders() ? 0.0 : std::abs(weight);
            });
            std::ranges::sort(all);
            return all;
        };
        EXPECT_EQ(leaving(*together), leaving(*both)) << cell;
    }
    EXPECT_GT(sunBeside, 0.1);

    std::vector<LightColumn> columns;
    for (int row = 0; row < 2 * rows; ++row) {
        for (const LightPattern pattern :
             {LightPattern::emission, LightPattern::sky, LightPattern::sun}) {
            columns.push_back({row, 0, pattern});
        }
    }
    for (int row = 0; row < 2 * rows; row += rows) {
        columns.push_back({row, 0, LightPattern::passedSky});
    }
    std::vector<LightKnot> knots;
    for (const double reflectivity : {0.6, 0.3}) {
        knots.push_back({std::vector<double>(both->rows(), reflectivity), {0.5, 0.8}, {}});
    }
    const LightSolution direct(*both, columns, knots, -1, 1e-7);
    LightSolutions solutions;
    const auto solved = solutions.of(together, columns, knots, -1, 1e-7);
    std::vector<double> most(columns.size());
    const auto expectEqual = [&](std::span<const float> own, std::span<const float> expected) {
        ASSERT_EQ(own.size(), expected.size());
        for (std::size_t k = 0; k < own.size(); ++k) {
            EXPECT_NEAR(own[k], expected[k], 2e-6) << k;
            double& largest = most[k % columns.size()];
            largest = std::max(largest, static_cast<double>(own[k]));
        }
    };
    // What stands behind these goes by the sets of panes, which have another order.
    for (std::size_t r = 0; r < both->receivers() + both->senders() + both->rows(); ++r) {
        expectEqual(solved->of(r), direct.of(r));
    }
    for (std::size_t s = 0; s < both->senders(); ++s) {
        expectEqual(solved->ofSender(s), direct.ofSender(s));
    }
    EXPECT_GT(*std::ranges::max_element(most), 0.1);
    EXPECT_GT(most.back(), 0.1) << "the sky through the pane of the second";
    EXPECT_EQ(solutions.of(together, columns, knots, -1, 1e-7), solved);
}
