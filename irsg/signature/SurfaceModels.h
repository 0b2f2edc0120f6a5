#pragma once

#include <memory>
#include <string>
#include <vector>

#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// How a material reflects over directions; null for a Lambertian one. Throws InputError for a
/// name, a number or a table that there is no model of. Models of equal materials are one.
std::shared_ptr<const SurfaceModel> surfaceModelOf(const Material& material);
/// "ggx", "beckmann", "sandfordRobertson", "shellTarget", "tabulated".
const std::vector<std::string>& surfaceModelNames();
/// Whether a material may name it: one of those, or none.
bool isSurfaceModel(const std::string& name);
/// The keys of a material's fields that a model takes beside emissivity and transmissivity.
const std::vector<std::string>& fieldsOfSurfaceModel(const std::string& name);

/// Directional-hemispherical reflectance at a cosine and a wavelength, of any material.
double reflectanceOverAngle(const Material& material, double cosine, double wavelength_um);
/// f, sr-1, of any material at a wavelength.
double brdf_per_sr(const Material& material, const SurfaceDirection& to,
                   const SurfaceDirection& from, double wavelength_um);

} // namespace irsg
