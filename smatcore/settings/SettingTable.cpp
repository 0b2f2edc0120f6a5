#include <utility>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/view/Sensor.h"
#include "irsg/image/ColorMap.h"
#include "irsg/render/values/RenderSettings.h"
#include "smatcore/settings/AnalysisSections.h"
#include "smatcore/settings/RenderWords.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace {

using namespace rows;

/// Of a scene of the library.
constexpr irsg::RenderSettings ofLibrary;

/// The mode of zoom antialiasing, or of supersampling.
int antialiasingOf(const irsg::RenderSettings& render) {
    const int finer =
        render.tileSide_samples > 0 ? render.tileSide_samples / 128 : render.samplesPerAxis;
    const int steps = finer > 2 ? 2 : finer - 1;
    return render.tileSide_samples > 0 ? 3 + steps : steps;
}

/// Takes up rows that stand on one page of the dialog of settings.
struct PageRows {
    std::vector<SettingInfo>& table;
    SettingPage page;

    void add(SettingInfo row, int place = 0) const {
        row.page = page;
        row.place = place;
        table.push_back(std::move(row));
    }
};

void addSensor(std::vector<SettingInfo>& table) {
    const PageRows sensor{table, SettingPage::sensor};
    const PageRows band{table, SettingPage::bandAndMode};
    sensor.add(integer(key::sensorWidth, "--width", "Width", "px", 1, irsg::largestResolution_px,
                       "640", "Columns of the detector."));
    sensor.add(integer(key::sensorHeight, "--height", "Height", "px", 1, irsg::largestResolution_px,
                       "512", "Rows of the detector."));
    sensor.add(number(key::sensorFov, "--fov", "Field of view", "deg", 1e-6, 179.0, "2",
                      "Horizontal field of view. Pixels are square, so the vertical one "
                      "follows from width and height."));
    band.add(bands(key::sensorBand, "--band", "Band", "3-5",
                   "Spectral band MIN-MAX with a response of 1 between its ends. Several, "
                   "separated by commas, give sweeps a curve each from the same renderings and "
                   "images a file each; they may overlap."));
    band.add(files(key::sensorResponse, "--response", "Response files",
                   "CSV files of wavelength and response, one for each band, separated by "
                   "semicolons; where given, they replace the bands."));
    band.add(named(
        choice(key::sensorMode, "--mode", "Calculation mode", {"auto", "spectral", "ck"}, "auto",
               "How the band integral is computed: spectral multiplies at every wavelength and "
               "integrates last; ck (correlated k) takes a few quadrature points, trained "
               "to a few thousandths. auto takes ck for sweeps over enough different lines of "
               "sight to pay "
               "for the training: 3 in air read from a file, 6 to 400 in computed air, depending "
               "on how much is asked of it for each; results say what it took and why. With auto, "
               "images and frames are spectral; spectra always are.",
               SettingAudience::expert),
        {"auto", "spectral", "wideband-ck"}));
}

void addViewAndTarget(std::vector<SettingInfo>& table) {
    const PageRows camera{table, SettingPage::cameraAndModel};
    camera.add(number(key::cameraRange, "--range", "Range", "m", 0, 1e8, "1000",
                      "Distance from the camera to the reference point of the target."));
    camera.add(number(key::cameraAzimuth, "--azimuth", "Azimuth", "deg", -360, 360, "0",
                      "Azimuth of the camera about the target: 0 looks at the nose, 90 sees the "
                      "starboard side. It turns with the yaw of the target."));
    camera.add(number(key::cameraElevation, "--elevation", "Elevation", "deg", -90, 90, "0",
                      "Elevation of the camera about the target: 0 is the horizontal plane, "
                      "positive looks down on the target."));
    camera.add(number(
        key::targetYaw, "--yaw", "Yaw", "deg", -360, 360, "0",
        "Turns the target counter-clockwise as seen from above; its heading is minus the yaw."));
    camera.add(
        number(key::targetPitch, "--pitch", "Pitch", "deg", -90, 90, "0", "Nose up is positive."));
    camera.add(number(key::targetRoll, "--roll", "Roll", "deg", -180, 180, "0",
                      "Starboard down is positive."));
    camera.add(number(key::targetAltitude, "--altitude", "Altitude", "m", 0, 1e6, "1000",
                      "Altitude of the target's origin above the ground. Neither camera nor "
                      "target may be below the ground."));
    camera.add(number(
        key::stateTime, "--time", "Time", "s", -1e9, 1e9, "0",
        "Time since the start of the scene: the axis of the time tables of a signature database."));
    camera.add(number(
        key::statePower, "--power", "Engine power", "", 0, 1e6, "0",
        "Power setting: the axis of the power tables of a signature database, usually 0 to 1."));
    camera.add(number(key::stateMach, "--mach", "Mach number", "", 0, 30, "0",
                      "Mach number of the target, for aerodynamic heating."));
}

void addScalings(std::vector<SettingInfo>& table) {
    const PageRows scalings{table, SettingPage::scalings};
    scalings.add(flag(key::scalingUse, "--scalings", "Use scalings", false,
                      "Multiplies temperatures and emissivities by the scale factors of the two "
                      "scaling files beside the model, drawn when the database is loaded. In a "
                      "scenario this is on where there are such files, unless it is set."));
    scalings.add(integer(
        key::scalingSeed, "--seed", "Seed", "", 0, 2147483647, "1",
        "Seed of the random scale factors: the same seed gives the same draw on every machine."));
}

void addEnvironment(std::vector<SettingInfo>& table) {
    const PageRows air{table, SettingPage::atmosphere};
    const PageRows sun{table, SettingPage::sunAndFluxes};
    air.add(files(key::environmentAtmospheres, "--atmosphere", "Atmospheres",
                  "Atmosphere files by priority, separated by semicolons; each quantity comes from "
                  "the first that has it in the band: .xml of an Environment, " +
                      irsg::atmosphereFormatWords() + ". Without any there is no air."));
    sun.add(number(key::environmentSunAzimuth, "--sun-azimuth", "Sun azimuth", "deg", 0, 360, "180",
                   "Azimuth of the sun, east of north; where it is not set, that of an Environment "
                   "file among the atmospheres."));
    sun.add(number(key::environmentSunElevation, "--sun-elevation", "Sun elevation", "deg", -90, 90,
                   "45",
                   "True elevation of the centre of the sun above the horizontal; the sun sets, "
                   "disc and all, at the horizon seen from the altitude. Where it is not set, that "
                   "of an Environment file among the atmospheres."));
    air.add(formerly(choice(key::environmentBins, "--bins", "Bins of computed air",
                            {"native", "1", "5", "15"}, "native",
                            "Width of the spectral bins of an AtmosphereSmart, in cm-1: native "
                            "keeps that of its file, 1, 5 or 15 replaces it; wider bins are "
                            "faster and less accurate. Refused for an atmosphere without bins.",
                            SettingAudience::expert),
                     {.choices = {{"own", "native"}}}));
    sun.add(choiceOrNumber(
        key::environmentDayOfYear, "--day-of-year", "Day of the year", "", {"mean"}, 1, 366, "mean",
        "Sets the distance of the sun, which changes the light of a computed atmosphere and of "
        "vacuum by -3.3 to +3.4 %; mean is one astronomical unit. Results of other programs and "
        "spectra from CSV files keep the day they were made for."));
    air.add(number(
        key::environmentAmbientTemperature, "--ambient-temperature", "Ambient temperature", "K", 1,
        5000, "288.15",
        "Air temperature that enters the surface temperatures where no atmosphere gives one."));
}

void addScattering(std::vector<SettingInfo>& table) {
    const PageRows scattering{table, SettingPage::scattering};
    scattering.add(file(key::environmentMtf, "--mtf", "MTF database",
                        "MTF database of scattering by droplets (.mtf, see smat-batch mtf), used "
                        "in place of an AtmosphereScatteringLUT among the atmospheres."));
    scattering.add(number(key::environmentScatteringCoefficient, "--scattering-coefficient",
                          "Scattering coefficient", "km-1", 0, 1e5, "0",
                          "Scattering coefficient of the droplets, constant along the path, for "
                          "the haze of that database; 0 takes it from the atmospheres. The "
                          "transmittance is always that of the atmospheres."));
}

void addSurroundings(std::vector<SettingInfo>& table) {
    const PageRows skybox{table, SettingPage::skybox};
    const PageRows terrain{table, SettingPage::terrain};
    const std::string scaleUnit = "W m-2 sr-1";
    skybox.add(files(key::environmentSkybox, "--skybox", "Skybox",
                     "Six square images around the viewpoint: a folder with north, south, east, "
                     "west, up and down (.png, .jpg, .tif, .exr, .hdr), or six files in that "
                     "order. The red channel is read as linear values."));
    skybox.add(number(key::environmentSkyboxSlope, "--skybox-slope", "Skybox slope", scaleUnit,
                      -1e9, 1e9, "1",
                      "In-band radiance from black (0) to white (1) of the skybox."));
    skybox.add(number(key::environmentSkyboxOffset, "--skybox-offset", "Skybox offset", "", -1e9,
                      1e9, "0", "Texel value of the skybox that stands for zero radiance."));
    terrain.add(file(key::environmentTerrain, "--terrain", "Terrain",
                     "Textured model, fixed in the world (x east, y north, z up), in any format of "
                     "OpenSceneGraph."));
    terrain.add(number(key::environmentTerrainSlope, "--terrain-slope", "Terrain slope", scaleUnit,
                       -1e9, 1e9, "1",
                       "In-band radiance from black (0) to white (1) of the terrain's "
                       "textures."));
    terrain.add(number(key::environmentTerrainOffset, "--terrain-offset", "Terrain offset", "",
                       -1e9, 1e9, "0",
                       "Texel value of the terrain that stands for zero radiance."));
    terrain.add(
        number(key::environmentTerrainEast, "--terrain-east", "Terrain east", "m", -1e7, 1e7, "0",
               "Position of the origin of the terrain file, east of the origin of the target."));
    terrain.add(number(
        key::environmentTerrainNorth, "--terrain-north", "Terrain north", "m", -1e7, 1e7, "0",
        "Position of the origin of the terrain file, north of the origin of the target."));
    terrain.add(number(key::environmentTerrainAltitude, "--terrain-altitude", "Terrain altitude",
                       "m", -1e5, 1e5, "0", "Altitude of the origin of the terrain file."));
}

void addRendering(std::vector<SettingInfo>& table) {
    const PageRows samples{table, SettingPage::antialiasing};
    const PageRows sun{table, SettingPage::sunAndFluxes};
    const PageRows band{table, SettingPage::bandAndMode};
    const PageRows air{table, SettingPage::atmosphere};
    const PageRows background{table, SettingPage::background};
    const PageRows scattering{table, SettingPage::scattering};
    const PageRows terrain{table, SettingPage::terrain};
    samples.add(
        named(choice(key::renderEngine, "--engine", "Engine", wordsOf(engineWords),
                     wordOf(engineWords, ofLibrary.engine),
                     "How samples are computed: opengl rasterizes off-screen; rays traces them "
                     "(Embree), gives the same answers and needs neither OpenGL nor a driver or "
                     "display; auto takes the faster for the scene, and results say which it was.",
                     SettingAudience::expert),
              {"OpenGL", "rays, without OpenGL", "whichever is quicker"}),
        3);
    SettingInfo antialiasing =
        integer(key::renderAntialiasing, "--antialiasing", "Antialiasing", "", 0, 5,
                std::to_string(antialiasingOf(ofLibrary)),
                "Mode 0: one sample per pixel. Modes 1 and 2: supersampling with 2 and 4 samples "
                "per axis of every pixel. Modes 3, 4 and 5: every object is rendered into a window "
                "of 128, 256 or 512 samples a side, however small it is.");
    antialiasing.names = {"0   none",
                          "1   supersampling 2 × 2",
                          "2   supersampling 4 × 4",
                          "3   zoom, 128 samples a side",
                          "4   zoom, 256 samples a side",
                          "5   zoom, 512 samples a side"};
    samples.add(std::move(antialiasing));
    samples.add(
        named(choice(key::renderZoom, "--zoom", "Zoom strategy", wordsOf(zoomWords),
                     wordOf(zoomWords, ofLibrary.tileStrategy),
                     "How the tiles of modes 3 to 5 are sampled: aligned to the sensor's pixel "
                     "grid, or sills, as published, for comparison; the energy of the latter "
                     "depends on where an object lies among the pixels.",
                     SettingAudience::expert),
              {"aligned on the pixels", "sills, as published"}),
        2);
    samples.add(
        number(
            key::renderPointSource, "--point-source", "Point sources below", "px", 0,
            irsg::largestPointSource_px, irsg::numberText(ofLibrary.pointSourceBelow_px),
            "Objects narrower than this fraction of a pixel are rendered once per aspect and then "
            "treated as point sources at any range (modes 3 to 5, aligned); 0 always renders them.",
            SettingAudience::expert),
        2);
    samples.add(
        formerly(flag(key::renderHotSpots, "--hot-spots", "Tiles for hot spots", ofLibrary.hotSpots,
                      "Renders hot spots, small parts that outshine the rest of their object such "
                      "as exhaust pipes, into tiles of their own (modes 3 to 5, aligned). Without "
                      "these, frames take a third of the time and hot spots are off by some "
                      "percent.",
                      SettingAudience::expert),
                 {.keys = {"render.hotParts"}, .options = {"--hot-parts"}}),
        2);
    samples.add(
        formerly(named(choice(key::renderSupersampling, "--supersampling", "Supersampling counts",
                              wordsOf(supersamplingWords),
                              wordOf(supersamplingWords, ofLibrary.countsPerPixel),
                              "Whether the 2 and 4 samples of modes 1 and 2 are counted per axis "
                              "of a pixel or per pixel.",
                              SettingAudience::expert),
                       {"per axis of a pixel", "per pixel"}),
                 {.choices = {{"inAll", "perPixel"}}}),
        1);
    const std::vector<std::string> reflections = wordsOf(reflectionWords);
    sun.add(named(choice(key::renderSun, "--sun", "Sun reflection", reflections,
                         wordOf(reflectionWords, ofLibrary.sun),
                         "Reflected sunlight: off, approx (independent of geometry: a quarter "
                         "everywhere) or smart (computed for each pixel)."),
                  {"off", "Approx. (a quarter everywhere)", "SMART (for each pixel)"}));
    sun.add(named(
        choice(key::renderShadows, "--shadows", "Shadows of the sun", wordsOf(shadowWords),
               wordOf(shadowWords, ofLibrary.sunShadows),
               "Shadows that the sun casts (sun smart) from other parts, other objects and "
               "terrain; transparent surfaces attenuate the sunlight by their transmissivity. The "
               "sun is a point source, or a disc of 0.53 degrees, whose shadows have a penumbra."),
        {"off", "of a point", "of a disc, with penumbra"}));
    sun.add(choiceOrNumber(
        key::renderBounces, "--bounces", "Inter-reflection", "", {"converged"}, 0, 1000,
        ofLibrary.bounces == irsg::convergedBounces ? "converged"
                                                    : std::to_string(ofLibrary.bounces),
        "Number of inter-reflections between surfaces: 0 for none, a whole number, "
        "or converged for all. Unless it is 0, surfaces block each other's view of "
        "sky and ground (view factors), and send each other thermal radiation and "
        "reflected light of sun, sky and ground instead. Takes time and memory with "
        "the first image of a model. Not available with ambient reflection approx."));
    sun.add(number(key::renderLightError, "--light-error", "Error of view factors", "", 0.0001, 0.1,
                   irsg::numberText(ofLibrary.lightError),
                   "Error of the view factors between surfaces, as a fraction of the hemisphere: "
                   "rays are added until two halves of them agree within it.",
                   SettingAudience::expert));
    band.add(number(
        key::renderWidebandError, "--wideband-error", "Error of wideband-ck", "", 5e-4, 0.05,
        irsg::numberText(ofLibrary.widebandError),
        "Largest relative error of an in-band quantity over the training cases of wideband-ck: a "
        "smaller one takes more points and longer training. A target error chooses it.",
        SettingAudience::expert));
    sun.add(formerly(
        named(choice(key::renderAmbientReflection, "--ambient-reflection", "Ambient reflection",
                     reflections, wordOf(reflectionWords, ofLibrary.ambientReflection),
                     "Reflected sky and ground radiation: off, approx (independent of geometry: a "
                     "half of each) or smart (computed for each pixel)."),
              {"off", "Approx. (a half of each)", "SMART (for each pixel)"}),
        {.keys = {"render.fluxes"}, .options = {"--fluxes"}}));
    sun.add(named(choice(key::renderFluxWeights, "--flux-weights", "Flux weights",
                         wordsOf(fluxWeightWords), wordOf(fluxWeightWords, ofLibrary.fluxWeights),
                         "Fractions of sky and ground that a tilted facet sees: its exact view "
                         "factors, or the angle over 180 degrees, as published.",
                         SettingAudience::expert),
                  {"exact view factor", "angle, as published"}));
    air.add(formerly(
        named(choice(key::renderReferenceTransmittance, "--reference-transmittance",
                     "Transmittance of measured spectra", wordsOf(referenceTransmittanceWords),
                     wordOf(referenceTransmittanceWords, ofLibrary.referenceTransmittance),
                     "Transmittance applied to a spectrum that was measured at a reference "
                     "distance: the ratio of those to the sensor and to the reference distance, "
                     "or that of the remaining segment of the path, as published.",
                     SettingAudience::expert),
              {"ratio of transmittances", "rest of the path, as published"}),
        {.keys = {"render.referenceAir"}, .options = {"--reference-air"}}));
    background.add(choiceOrNumber(
        key::renderBackground, "--background", "Background", "W m-2 sr-1", {"smart", "none"}, 0,
        1e9, "smart",
        "Radiance behind the models: smart takes that of sky or ground in the apparent directions "
        "of each object, along one line of sight or a grid of rows and columns; none is 0; a "
        "number is an in-band radiance. Skybox, sun and terrain come on top."));
    background.add(integer(
        key::renderBackgroundRows, "--background-rows", "Background rows", "", 0,
        irsg::largestBackgroundGrid, std::to_string(ofLibrary.backgroundRows),
        "Rows of lines of sight along which a smart background is computed, on both sides of the "
        "horizon where it is in view. 0 is automatic: intensities take the directions that each "
        "object covers, as many as 0.02 % of the background needs, and images as many rows as half "
        "a percent needs. One row and one column give a uniform background."));
    background.add(integer(
        key::renderBackgroundColumns, "--background-columns", "Background columns", "", 1,
        irsg::largestBackgroundGrid, std::to_string(ofLibrary.backgroundColumns),
        "Columns of that grid: one is enough unless the sun makes the sky vary with azimuth."));
    background.add(
        flag(key::renderSunDisc, "--sun-disc", "Sun disc", ofLibrary.sunDisc,
             "Draws the sun as a disc of 0.53 degrees where nothing hides it; a skybox should then "
             "have no sun of its own. In a scenario this is on, unless it is set."));
    scattering.add(flag(key::renderScattering, "--scattering", "Scattering", ofLibrary.scattering,
                        "Adds to images the haze that droplets scatter around objects. Needs an "
                        "MTF database, or an AtmosphereScatteringLUT among the atmospheres; works "
                        "with every antialiasing mode, and in sums over objects."),
                   -1);
    terrain.add(
        flag(key::renderTerrainHides, "--terrain-hides", "Terrain hides", ofLibrary.terrainHides,
             "Terrain hides what is behind it; otherwise it is a picture behind all objects.",
             SettingAudience::expert));
    samples.add(named(choice(key::renderErrors, "--errors", "Errors of results",
                             {"off", "sum", "causes"}, ofLibrary.errors ? "sum" : "off",
                             "Error bounds (95 %) beside the intensities, contrast and irradiance "
                             "of sweeps, spectra and images: their sum, or also by cause "
                             "(sampling, air, background, inter-reflection)."),
                      {"off", "sum of all causes", "by cause"}));
    samples.add(named(choice(key::renderParts, "--by-part", "Contributions by part",
                             {"none", "temperature", "material"}, "none",
                             "Columns of sweeps for what the faces of each temperature or material "
                             "index add to the sums of their object; those of an object add up to "
                             "it. Images, spectra and scenarios have no such columns."),
                      {"none", "by temperature index", "by material index"}));
    samples.add(choiceOrNumber(
        key::renderTargetError, "--target-error", "Target error", "%", {"none"}, 0.001, 50, "none",
        "Largest error of the intensities and contrasts of sweeps and images, relative to them, or "
        "to a tenth of the largest contrast. The cheapest windows, bins of computed air or "
        "wideband-ck and rows of background that meet it replace those that are set, and light "
        "whose bound is a small part of it is left out; results say what and why, and have the sum "
        "of their errors. Spectra stay as they are set."));
    samples.add(integer(key::renderLayers, "--layers", "Transparent layers", "", 1, 1000,
                        std::to_string(ofLibrary.maximumLayers),
                        "Transparent surfaces kept per sample, nearest first; samples with more of "
                        "them are counted and reported.",
                        SettingAudience::expert),
                2);
}

void addDisplay(std::vector<SettingInfo>& table) {
    const PageRows colours{table, SettingPage::colours};
    colours.add(
        choice(key::displayColorMap, "--color-map", "Colour map", irsg::ColorMap::names(),
               irsg::ColorMap::defaultName,
               "Colours of PNG files and of the image window; data files are not affected."));
    colours.add(
        choice(key::displayScale, "--color-scale", "Colour scale", irsg::colorScaleNames(),
               irsg::nameOf(irsg::ColorScale::automatic),
               "How colours follow values between the darkest and the brightest: linear, by the "
               "square root, by the logarithm over four decades, or equalized, with as many values "
               "for every colour; auto is the first of these that leaves colours for what does not "
               "glow. Except with linear, automatic limits include the hottest pixels."));
    colours.add(flag(key::displayMarkOutside, "--mark-outside", "Mark what is out of range", false,
                     "Gives pixels darker than the darkest or brighter than the brightest value "
                     "colours of their own; otherwise they have those of the ends."));
    colours.add(choiceOrNumber(key::displayMinimum, "--display-minimum", "Darkest value", "",
                               {"auto"}, -1e30, 1e30, "auto",
                               "Value of the first colour, in the unit of the image; auto shows "
                               "the object and its background."));
    colours.add(
        choiceOrNumber(key::displayMaximum, "--display-maximum", "Brightest value", "", {"auto"},
                       -1e30, 1e30, "auto",
                       "Value of the last colour, in the unit of the image; auto is the hottest "
                       "pixel, but leaves out the few hottest where the scale was set to linear."));
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
