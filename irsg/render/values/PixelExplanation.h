#pragma once

#include <optional>
#include <string>
#include <vector>

namespace irsg {

/// What a surface adds to a pixel in one of the RadianceTerms.
struct ExplainedTerm {
    std::string name;
    double factor = 0.0;              ///< of geometry, mean over what the surface covers
    double atFactorOne_W_m2_sr = 0.0; ///< likewise, behind what lies before it and the air
    std::optional<double> light;      ///< in the band: W m-2 onto it, W m-2 sr-1 of the path
    double radiance_W_m2_sr = 0.0;    ///< what the pixel has of it
};

/// One surface of a pixel in one layer, behind one set of transparent materials.
struct ExplainedSurface {
    int layer = 1;           ///< 1 is the nearest
    bool lightAlone = false; ///< light that it gets through `throughMaterials`; covers nothing more
    std::string object;
    int temperatureIndex = 0, materialIndex = 0;
    std::string temperatureName, materialName;
    double temperature_K = 0.0; ///< 0 for a measured spectrum
    std::string measuredSpectrum;
    // Means over the band, weighted with its response.
    double emissivity = 0.0, reflectivity = 0.0, transmissivity = 0.0;
    double throughTransmittance = 1.0; ///< of all that stands before it but the air
    double atmosphereTransmittance = 1.0;
    double nAngleFactor = 0.0;
    std::vector<std::string> throughMaterials; ///< "object: index name"
    double share = 0.0;                        ///< of the pixel's area
    double range_m = 0.0;                      ///< mean; of a point that of its object
    std::vector<ExplainedTerm> terms;
    double betweenSurfaces_W_m2_sr = 0.0; ///< light of other surfaces
    double hidden_W_m2_sr = 0.0;          ///< of the background, that it takes away
    double radiance_W_m2_sr = 0.0;        ///< of its terms, light of others included
};

/// What a pixel's in-band radiance is made of: that of all surfaces, and of the background what
/// they leave.
struct PixelExplanation {
    int x = 0, y = 0; ///< from the left and from the top
    std::vector<ExplainedSurface> surfaces;
    double background_W_m2_sr = 0.0; ///< behind the objects
    /// Its parts before they were added up; none where it is uniform.
    std::optional<double> sky_W_m2_sr, environment_W_m2_sr, terrain_W_m2_sr;
    double backgroundLeft_W_m2_sr = 0.0; ///< that arrives
    double radiance_W_m2_sr = 0.0;       ///< of all
    int samples = 0;                     ///< rays through the pixel; 0: no object is near
    int layersLeftOver = 0;              ///< of them with more layers than the settings keep
    /// The middles of the 3 x 3 pixels and all samples of this one meet the same facets in the same
    /// order, or none.
    bool isInterior = false;
    std::vector<std::string> remarks;
};

} // namespace irsg
