#include "irsg/geometry/view/Sensor.h"

#include <cmath>

#include <gmock/gmock.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {
namespace {

using testing::HasSubstr;

Sensor sensorOf(int width, int height, double fieldOfView_deg) {
    Sensor sensor;
    sensor.width_px = width;
    sensor.height_px = height;
    sensor.horizontalFieldOfView_rad = radians(fieldOfView_deg);
    return sensor;
}

double sumOfSolidAngles(const Sensor& sensor) {
    double sum = 0.0;
    for (int y = 0; y < sensor.height_px; ++y) {
        for (int x = 0; x < sensor.width_px; ++x) {
            sum += sensor.pixelSolidAngle_sr(x, y);
        }
    }
    return sum;
}

/// Solid angle of the pyramid over a rectangle with half sides a, b at unit distance.
double pyramid(const Sensor& sensor) {
    const double a = std::tan(0.5 * sensor.horizontalFieldOfView_rad);
    const double b = a * sensor.height_px / sensor.width_px;
    return 4.0 * std::atan(a * b / std::sqrt(1.0 + a * a + b * b));
}

TEST(Sensor, OfOnePixelAtTheAxisSeesThePitchSquared) {
    const Sensor sensor = sensorOf(1, 1, 2.0);
    EXPECT_DOUBLE_EQ(sensor.pixelPitch(), 2.0 * std::tan(radians(1.0)));
    EXPECT_DOUBLE_EQ(sensor.cosOffAxis(0, 0), 1.0);
    EXPECT_DOUBLE_EQ(sensor.pixelSolidAngle_sr(0, 0), sensor.pixelPitch() * sensor.pixelPitch());
    // The next term of the mid point rule: p^2 / 24 times the Laplacian of cos^3, 6 on the axis.
    const double excess = sensor.pixelPitch() * sensor.pixelPitch() / 4.0;
    EXPECT_NEAR(sumOfSolidAngles(sensor) / pyramid(sensor), 1.0 + excess, 0.01 * excess);
}

TEST(Sensor, CornersOfNinetyDegreesHaveTheirClosedForm) {
    // Two pixels a side, pitch 1: the centres stand at (1/2, 1/2), cos^2 = 1 / 1.5.
    const Sensor sensor = sensorOf(2, 2, 90.0);
    EXPECT_NEAR(sensor.pixelPitch(), 1.0, 1e-15);
    for (const int x : {0, 1}) {
        for (const int y : {0, 1}) {
            EXPECT_NEAR(sensor.cosOffAxis(x, y), 1.0 / std::sqrt(1.5), 1e-15);
            EXPECT_NEAR(sensor.pixelSolidAngle_sr(x, y), std::pow(1.5, -1.5), 1e-15);
        }
    }
}

TEST(Sensor, PitchIsThatOfTheWidthAndPixelsAreSquare) {
    EXPECT_DOUBLE_EQ(sensorOf(640, 1, 30).pixelPitch(), sensorOf(640, 512, 30).pixelPitch());
    EXPECT_DOUBLE_EQ(sensorOf(320, 512, 30).pixelPitch(), 2 * sensorOf(640, 512, 30).pixelPitch());
}

TEST(Sensor, IsSymmetricAboutItsAxis) {
    for (const auto& [width, height] : {std::pair{7, 5}, {8, 3}, {1, 9}, {64, 64}}) {
        const Sensor sensor = sensorOf(width, height, 70.0);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                EXPECT_DOUBLE_EQ(sensor.cosOffAxis(x, y),
                                 sensor.cosOffAxis(width - 1 - x, height - 1 - y));
                EXPECT_DOUBLE_EQ(sensor.cosOffAxis(x, y), sensor.cosOffAxis(width - 1 - x, y));
            }
        }
    }
}

TEST(Sensor, SumsOverItsPixelsToTheSolidAngleOfItsPyramid) {
    // The mid point rule is wrong by at most p^2 / 4 of the whole: its next term, largest on axis.
    const struct {
        int width, height;
        double fieldOfView_deg;
    } rows[] = {{640, 512, 2.0}, {640, 512, 40.0}, {640, 512, 120.0}, {101, 37, 60.0},
                {1, 64, 1.0},    {1024, 1, 90.0},  {17, 31, 5.0},     {16384, 1, 170.0}};
    for (const auto& row : rows) {
        const Sensor sensor = sensorOf(row.width, row.height, row.fieldOfView_deg);
        const double bound = 0.25 * sensor.pixelPitch() * sensor.pixelPitch();
        EXPECT_NEAR(sumOfSolidAngles(sensor) / pyramid(sensor), 1.0, bound + 1e-12)
            << row.width << " x " << row.height << " " << row.fieldOfView_deg;
    }
}

TEST(Sensor, ConvergesAtSecondOrderWhenPixelsAreHalved) {
    // The mid point rule: a quarter of the error at half the pixel.
    double coarse = 0.0;
    for (int size = 8; size <= 256; size *= 2) {
        const Sensor sensor = sensorOf(size, size, 80.0);
        const double error = sumOfSolidAngles(sensor) - pyramid(sensor);
        if (size > 8) {
            EXPECT_NEAR(coarse / error, 4.0, 0.1) << size;
        }
        coarse = error;
    }
}

TEST(Sensor, AcceptsWhatLiesWithinItsLimits) {
    for (const Sensor& sensor :
         {Sensor{}, sensorOf(1, 1, 1e-9), sensorOf(16384, 16384, 179.999), sensorOf(1, 16384, 1)}) {
        EXPECT_NO_THROW(sensor.check());
    }
}

TEST(Sensor, RefusesWhatNoCameraHas) {
    const struct {
        const char* name;
        Sensor sensor;
        const char* says;
    } rows[] = {
        {"no width", sensorOf(0, 5, 2), "width: found 0, expected 1 to 16384 px"},
        {"negative height", sensorOf(5, -3, 2), "height: found -3"},
        {"too wide", sensorOf(16385, 5, 2), "width: found 16385"},
        {"no field of view", sensorOf(5, 5, 0), "field of view: found 0 deg"},
        {"negative field of view", sensorOf(5, 5, -90), "field of view: found -90 deg"},
        {"half the world", sensorOf(5, 5, 180), "less than 180 deg"},
        {"NaN field of view", sensorOf(5, 5, std::nan("")), "field of view: found nan deg"},
    };
    for (const auto& row : rows) {
        try {
            row.sensor.check();
            ADD_FAILURE() << row.name;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(row.says)) << row.name;
        }
    }
}

TEST(Sensor, NamesAllThatIsWrongAtOnce) {
    try {
        sensorOf(0, 0, 200).check();
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 3U);
    }
}

} // namespace
} // namespace irsg
