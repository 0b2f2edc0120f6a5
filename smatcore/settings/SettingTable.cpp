#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/image/ColorMap.h"
#include "irsg/scene/values/RenderSettings.h"
#include "irsg/scene/view/Sensor.h"
#include "smatcore/settings/AnalysisSections.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace {

using namespace rows;

void addSensor(std::vector<SettingInfo>& table) {
    table.push_back(integer(key::sensorWidth, "--width", "Width", "px", 1,
                            irsg::largestResolution_px, "640", "Columns of the detector."));
    table.push_back(integer(key::sensorHeight, "--height", "Height", "px", 1,
                            irsg::largestResolution_px, "512", "Rows of the detector."));
    table.push_back(number(key::sensorFov, "--fov", "Field of view", "deg", 1e-6, 179.0, "2",
                           "Horizontal field of view. Pixels are square, so the vertical one "
                           "follows from width and height."));
    table.push_back(
        bands(key::sensorBand, "--band", "Band", "3-5",
              "Spectral band MIN-MAX with a response of 1 between its ends. Several, "
              "separated by commas, give sweeps a curve each from the same drawings and "
              "images a file each; they may overlap."));
    table.push_back(files(key::sensorResponse, "--response", "Response files",
                          "CSV of wavelength and response, one for each band, separated by "
                          "semicolons; where they are given they stand in for all of the bands."));
    table.push_back(named(
        choice(key::sensorMode, "--mode", "Calculation mode", {"auto", "spectral", "ck"}, "auto",
               "How the band is integrated. Spectral multiplies at every wavelength and "
               "integrates last; ck does so at a few quadrature points that the air is asked for, "
               "trained to a "
               "few thousandths. Auto takes ck for sweeps over so many different lines of sight "
               "that they pay for training, 3 in air of a file, 6 to 400 in computed air by how "
               "much it is asked for each; results say what it took and why. Images and frames "
               "are then spectral; spectra always are.",
               SettingAudience::expert),
        {"auto", "spectral", "wideband-ck"}));
}

void addViewAndTarget(std::vector<SettingInfo>& table) {
    table.push_back(number(key::cameraRange, "--range", "Range", "m", 0, 1e8, "1000",
                           "Distance from the camera to the reference point of the target."));
    table.push_back(
        number(key::cameraAzimuth, "--azimuth", "Azimuth", "deg", -360, 360, "0",
               "Azimuth of the camera about the target: 0 looks at the nose, 90 sees the "
               "starboard side. It turns with the target's yaw."));
    table.push_back(number(key::cameraElevation, "--elevation", "Elevation", "deg", -90, 90, "0",
                           "Elevation of the camera about the target; 0 is the horizontal plane, "
                           "positive looks down on it."));
    table.push_back(
        number(key::targetYaw, "--yaw", "Yaw", "deg", -360, 360, "0",
               "Turns the target counter-clockwise seen from above; its heading is minus "
               "the yaw."));
    table.push_back(
        number(key::targetPitch, "--pitch", "Pitch", "deg", -90, 90, "0", "Nose up is positive."));
    table.push_back(number(key::targetRoll, "--roll", "Roll", "deg", -180, 180, "0",
                           "Starboard down is positive."));
    table.push_back(number(key::targetAltitude, "--altitude", "Altitude", "m", 0, 1e6, "1000",
                           "Altitude of the target's origin above the ground. Neither camera nor "
                           "target may be below the ground."));
    table.push_back(number(key::stateTime, "--time", "Time", "s", -1e9, 1e9, "0",
                           "Time since the scene began: the axis of the time tables of a signature "
                           "database."));
    table.push_back(number(key::statePower, "--power", "Engine power", "", 0, 1e6, "0",
                           "Power setting: the axis of the power tables of a signature database, 0 "
                           "to 1 by custom."));
    table.push_back(number(key::stateMach, "--mach", "Mach number", "", 0, 30, "0",
                           "Speed of the target for aerodynamic heating."));
}

void addScalings(std::vector<SettingInfo>& table) {
    table.push_back(flag(key::scalingUse, "--scalings", "Use scalings", false,
                         "Multiplies temperatures and emissivities with the scales of the two "
                         "scaling files beside the model, drawn when the database is loaded. In a "
                         "scenario on where there are such files, unless it says otherwise."));
    table.push_back(integer(key::scalingSeed, "--seed", "Seed", "", 0, 2147483647, "1",
                            "Names the random numbers of the scales: the same seed gives the same "
                            "draw on every machine, another seed another one."));
}

void addEnvironment(std::vector<SettingInfo>& table) {
    table.push_back(files(
        key::environmentAtmospheres, "--atmosphere", "Atmospheres",
        "Atmosphere files in order, separated by semicolons; the first that has the asked quantity "
        "in the band answers: .xml of an Environment, " +
            irsg::atmosphereFormatWords() + ". With none there is no air."));
    table.push_back(number(key::environmentSunAzimuth, "--sun-azimuth", "Sun azimuth", "deg", 0,
                           360, "180",
                           "Azimuth of the sun, east of north; where it is not set, that of an "
                           "Environment file among the atmospheres."));
    table.push_back(number(
        key::environmentSunElevation, "--sun-elevation", "Sun elevation", "deg", -90, 90, "45",
        "True elevation of the middle of the sun above the horizontal; it sets at the horizon of "
        "the altitude, with its disc. Where it is not set, that of an Environment file among the "
        "atmospheres."));
    table.push_back(choice(
        key::environmentBins, "--bins", "Bins of computed air", {"own", "1", "5", "15"}, "own",
        "Width of the bins of an AtmosphereSmart, cm-1: own, or in place of its file's 1, 5 or "
        "15; wider ones are quicker and less exact. Air without bins refuses it.",
        SettingAudience::expert));
    table.push_back(choiceOrNumber(
        key::environmentDayOfYear, "--day-of-year", "Day of the year", "", {"mean"}, 1, 366, "mean",
        "For the distance of the sun, which changes the light of a computed atmosphere and of "
        "vacuum by -3.3 to +3.4 %; mean: one astronomical unit. Results of other programs and "
        "spectra of CSV files are of their own day."));
    table.push_back(number(key::environmentAmbientTemperature, "--ambient-temperature",
                           "Ambient temperature", "K", 1, 5000, "288.15",
                           "Air temperature that surfaces take part of, where no atmosphere gives "
                           "one."));
}

void addScattering(std::vector<SettingInfo>& table) {
    table.push_back(file(key::environmentMtf, "--mtf", "MTF database",
                         "How droplets spread light (.mtf, see smat-batch mtf): what scattering "
                         "uses in place of an AtmosphereScatteringLUT among the atmospheres."));
    table.push_back(number(key::environmentScatteringCoefficient, "--scattering-coefficient",
                           "Scattering coefficient", "km-1", 0, 1e5, "0",
                           "Scattering by droplets of one concentration along the path, for the "
                           "haze of that database; 0 leaves it to the atmospheres. The "
                           "transmittance is theirs in any case."));
}

void addSurroundings(std::vector<SettingInfo>& table) {
    const std::string scaleUnit = "W m-2 sr-1";
    table.push_back(files(key::environmentSkybox, "--skybox", "Skybox",
                          "Six square pictures around the eye: a folder that holds north, south, "
                          "east, west, up and down (.png, .jpg, .tif, .exr, .hdr), or six files "
                          "in that order. Their red channel is read as linear numbers."));
    table.push_back(number(key::environmentSkyboxSlope, "--skybox-slope", "Skybox slope", scaleUnit,
                           -1e9, 1e9, "1",
                           "In-band radiance from black (0) to white (1) of the skybox."));
    table.push_back(number(key::environmentSkyboxOffset, "--skybox-offset", "Skybox offset", "",
                           -1e9, 1e9, "0",
                           "Value of the skybox that adds nothing to the background."));
    table.push_back(file(key::environmentTerrain, "--terrain", "Terrain",
                         "Textured model that stands fixed in the world, x east, y north, z up, in "
                         "any format of OpenSceneGraph."));
    table.push_back(number(key::environmentTerrainSlope, "--terrain-slope", "Terrain slope",
                           scaleUnit, -1e9, 1e9, "1",
                           "In-band radiance from black (0) to white (1) of the terrain's "
                           "textures."));
    table.push_back(number(key::environmentTerrainOffset, "--terrain-offset", "Terrain offset", "",
                           -1e9, 1e9, "0",
                           "Value of the terrain's textures that adds nothing to the background."));
    table.push_back(number(key::environmentTerrainEast, "--terrain-east", "Terrain east", "m", -1e7,
                           1e7, "0",
                           "Where the origin of the terrain's file stands, east of the target's "
                           "origin."));
    table.push_back(number(key::environmentTerrainNorth, "--terrain-north", "Terrain north", "m",
                           -1e7, 1e7, "0", "The same, north of the target's origin."));
    table.push_back(number(key::environmentTerrainAltitude, "--terrain-altitude",
                           "Terrain altitude", "m", -1e5, 1e5, "0",
                           "Altitude of the origin of the terrain's file."));
}

void addRendering(std::vector<SettingInfo>& table) {
    table.push_back(
        named(choice(key::renderEngine, "--engine", "Engine", {"opengl", "rays", "auto"}, "opengl",
                     "Who answers samples: opengl draws them off-screen; rays (Embree) give the "
                     "same answers and need neither OpenGL nor a driver or display; auto takes "
                     "whichever is the quicker for the scene, and results say which it was.",
                     SettingAudience::expert),
              {"OpenGL", "rays, without OpenGL", "whichever is quicker"}));
    SettingInfo antialiasing = integer(
        key::renderAntialiasing, "--antialiasing", "Antialiasing", "", 0, 5, "4",
        "Mode 0: one sample a pixel. Modes 1 and 2: 2 and 4 samples per axis in every pixel. Modes "
        "3, 4 and 5: every object is drawn into a window of 128, 256 or 512 samples a side, "
        "however small it is.");
    antialiasing.names = {"0   none",
                          "1   supersampling 2 × 2",
                          "2   supersampling 4 × 4",
                          "3   zoom, 128 samples a side",
                          "4   zoom, 256 samples a side",
                          "5   zoom, 512 samples a side"};
    table.push_back(std::move(antialiasing));
    table.push_back(
        named(choice(key::renderZoom, "--zoom", "Zoom strategy", {"aligned", "sills"}, "aligned",
                     "How modes 3 to 5 sample: aligned on the sensor's pixel grid, or sills, "
                     "as published, to compare with: it loses and gains energy with the place "
                     "of an object among the pixels.",
                     SettingAudience::expert),
              {"aligned on the pixels", "sills, as published"}));
    table.push_back(number(
        key::renderPointSource, "--point-source", "Point sources below", "px", 0, 1, "0.015625",
        "Objects narrower than this part of a pixel are drawn once per aspect "
        "and then stand for any range as points (modes 3 to 5, aligned); 0 draws "
        "them always.",
        SettingAudience::expert));
    table.push_back(flag(key::renderHotParts, "--hot-parts", "Windows for hot parts", true,
                         "Small parts that shine out of their object, such as exhaust pipes, are "
                         "drawn into windows of their own (modes 3 to 5, aligned); without them "
                         "frames take a third of the time and such parts are some percent off.",
                         SettingAudience::expert));
    table.push_back(
        named(choice(key::renderSupersampling, "--supersampling", "Supersampling counts",
                     {"perAxis", "inAll"}, "perAxis",
                     "Whether the 2 and 4 samples of modes 1 and 2 are meant per axis of a "
                     "pixel or in all.",
                     SettingAudience::expert),
              {"per axis of a pixel", "in all of a pixel"}));
    const std::vector<std::string> reflections = {"off", "approx", "smart"};
    table.push_back(named(choice(key::renderSun, "--sun", "Sun reflection", reflections, "smart",
                                 "Reflected sun: off, approx (independent of geometry: a quarter "
                                 "everywhere) or smart (computed for each pixel)."),
                          {"off", "Approx. (a quarter everywhere)", "SMART (for each pixel)"}));
    table.push_back(
        named(choice(key::renderShadows, "--shadows", "Shadows of the sun",
                     {"off", "point", "disc"}, "point",
                     "What stands between a surface and the sun takes its light away (sun smart): "
                     "other parts, other objects, terrain; what is transparent weakens it by its "
                     "transmissivity. The sun is a point, or a disc of 0.53 degrees, whose shadows "
                     "have a penumbra."),
              {"off", "of a point", "of a disc, with penumbra"}));
    table.push_back(choiceOrNumber(
        key::renderBounces, "--bounces", "Light between surfaces", "", {"converged"}, 0, 1000,
        "converged",
        "How often light goes from surface to surface before it goes to the sensor: 0 for never, "
        "a whole number, or converged for all of it. Where it does, what stands before a surface "
        "takes the light of sky and ground away from it and sends its own in its place: thermal, "
        "and reflected of sun, sky and ground. Takes time and memory with the first picture of a "
        "model. Not with fluxes approx."));
    table.push_back(number(key::renderLightError, "--light-error", "Error of view factors", "",
                           0.0001, 0.1, "0.005",
                           "Error of the view factors between surfaces, as a part of the "
                           "hemisphere: rays are sent until their two halves agree so well.",
                           SettingAudience::expert));
    table.push_back(number(key::renderWidebandError, "--wideband-error", "Error of wideband-ck", "",
                           5e-4, 0.05, "0.003",
                           "Largest error of an in-band quantity on the cases that the quadrature "
                           "points of wideband-ck are trained on, relative: less takes more points "
                           "and longer training. A target error chooses it.",
                           SettingAudience::expert));
    table.push_back(
        named(choice(key::renderFluxes, "--fluxes", "Flux reflection", reflections, "smart",
                     "Reflected sky and ground: off, approx (independent of geometry: a half "
                     "of each) or smart (computed for each pixel)."),
              {"off", "Approx. (a half of each)", "SMART (for each pixel)"}));
    table.push_back(
        named(choice(key::renderFluxWeights, "--flux-weights", "Flux weights",
                     {"viewFactor", "report"}, "viewFactor",
                     "Share of sky and ground a tilted facet sees: its exact view factor, or "
                     "the angle over 180 degrees as published.",
                     SettingAudience::expert),
              {"exact view factor", "angle, as published"}));
    table.push_back(
        named(choice(key::renderReferenceAir, "--reference-air", "Air of measured spectra",
                     {"ratio", "segment"}, "ratio",
                     "What a spectrum passes that was measured at a reference distance: the ratio "
                     "of the transmittances to sensor and reference distance, or that of the "
                     "segment which is left of the path, as published.",
                     SettingAudience::expert),
              {"ratio of transmittances", "rest of the path, as published"}));
    table.push_back(
        choiceOrNumber(key::renderBackground, "--background", "Background", "W m-2 sr-1",
                       {"smart", "none"}, 0, 1e9, "smart",
                       "What lies behind the models: smart asks the environment along "
                       "the line of sight at the field's centre, or along rows and columns of "
                       "them; none is 0, a number is an in-band radiance. Skybox, sun and terrain "
                       "come on top."));
    table.push_back(integer(key::renderBackgroundRows, "--background-rows", "Background rows", "",
                            0, irsg::largestBackgroundGrid, "1",
                            "Rows of lines of sight over the field that a smart background is "
                            "asked along, on both sides of the horizon where it is in the field. "
                            "One row and one column is a uniform background; 0 is as many rows as "
                            "half a percent of the radiance needs."));
    table.push_back(integer(key::renderBackgroundColumns, "--background-columns",
                            "Background columns", "", 1, irsg::largestBackgroundGrid, "1",
                            "Columns of the same: one does unless the sun makes the sky change "
                            "with azimuth."));
    table.push_back(flag(key::renderSunDisc, "--sun-disc", "Sun disc", false,
                         "Draws the sun as a disc of 0.53 degrees where nothing hides it; a "
                         "skybox should have no sun of its own then. In a scenario on, unless it "
                         "says otherwise."));
    table.push_back(
        flag(key::renderScattering, "--scattering", "Scattering", false,
             "Images show the haze that droplets scatter around objects. Needs an MTF "
             "database, or an AtmosphereScatteringLUT among the atmospheres; works with "
             "every antialiasing. Sums over objects stay those of direct light."));
    table.push_back(flag(key::renderTerrainHides, "--terrain-hides", "Terrain hides", true,
                         "Terrain hides what is behind it; else it is a picture behind all "
                         "objects.",
                         SettingAudience::expert));
    table.push_back(named(
        choice(key::renderErrors, "--errors", "Errors of results", {"off", "sum", "causes"}, "off",
               "Errors beside the intensities, contrast and irradiance of sweeps, spectra and "
               "images, which "
               "the truth lies within 19 times out of 20: their sum, or by their causes, too "
               "(samples, air, background). Takes up to twice the time."),
        {"off", "sum of all causes", "by cause"}));
    table.push_back(choiceOrNumber(
        key::renderTargetError, "--target-error", "Target error", "%", {"none"}, 0.001, 50, "none",
        "Largest error of the intensities and contrasts of sweeps and images, as a part of them, "
        "or "
        "of a tenth of the largest contrast. The cheapest windows, bins of computed air or "
        "wideband-ck and rows of background that meet it are chosen in place of those that are "
        "set, and light is left out whose bound is a part of it; results say what and why, and "
        "have the sum of their errors. A spectrum stays as it is set."));
    table.push_back(
        integer(key::renderLayers, "--layers", "Transparent layers", "", 1, 1000, "64",
                "Transparent surfaces kept per sample, nearest first; samples with more "
                "of them are counted and reported.",
                SettingAudience::expert));
}

void addDisplay(std::vector<SettingInfo>& table) {
    table.push_back(
        choice(key::displayColorMap, "--color-map", "Colour map", irsg::ColorMap::names(),
               irsg::ColorMap::defaultName,
               "Colours of PNG files and of the image window; data are never coloured."));
    table.push_back(
        choice(key::displayScale, "--color-scale", "Colour scale", irsg::colorScaleNames(),
               irsg::nameOf(irsg::ColorScale::automatic),
               "How colours follow values between darkest and brightest: linear, by the square "
               "root, by the logarithm over four decades, or equalized, every colour for as many "
               "of the values; auto is the first of these that leaves colours for what does not "
               "glow. With all but linear, limits found by themselves hold the hottest pixels, "
               "too."));
    table.push_back(flag(key::displayMarkOutside, "--mark-outside", "Mark what is out of range",
                         false,
                         "Pixels darker than the darkest or brighter than the brightest value have "
                         "colours of their own; else those of the ends."));
    table.push_back(choiceOrNumber(key::displayMinimum, "--display-minimum", "Darkest value", "",
                                   {"auto"}, -1e30, 1e30, "auto",
                                   "Value that has the first colour, in the unit of the picture; "
                                   "auto shows the object and its background."));
    table.push_back(choiceOrNumber(key::displayMaximum, "--display-maximum", "Brightest value", "",
                                   {"auto"}, -1e30, 1e30, "auto",
                                   "Value that has the last colour, in the unit of the picture; "
                                   "auto is the hottest pixel, but leaves out the few hottest "
                                   "where the scale is linear by choice."));
}

} // namespace

const std::vector<SettingInfo>& settingTable() {
    static const std::vector<SettingInfo> table = [] {
        std::vector<SettingInfo> made;
        addSensor(made);
        addViewAndTarget(made);
        addScalings(made);
        addEnvironment(made);
        addScattering(made);
        addSurroundings(made);
        addRendering(made);
        addDisplay(made);
        for (const AnalysisSection& section : analysisSections())
            made.insert(made.end(), section.settings->begin(), section.settings->end());
        return made;
    }();
    return table;
}

} // namespace smat
