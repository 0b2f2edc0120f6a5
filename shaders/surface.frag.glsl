#version 430 compatibility
// Apparent radiance of one sample of a surface (docs/physics.md, equations 1 to 3), or its factors.
// All radiances are in-band, W m-2 sr-1, computed in double on the CPU.
//
// Compiled once for each combination of what a drawing needs, so that nothing is computed in vain:
//   PRODUCT     0 radiance, 1 factors, 2 factors and distance
//   SUN_MODE    0 off, 1 independent of geometry, 2 per sample
//   FLUX_MODE   0 off, 1 independent of geometry, 2 view factors, 3 the report's angles
//   ANGLE_MODE  0: N = 0, 1: N = 1, 2: any N
//   TRANSPARENT 0: the nearest surface is drawn, 1: every surface before it is appended to a list

in vec3 eyePosition; // m, not normalised
in vec3 eyeNormal;   // any length

uniform vec4 radiance;  // thermal, upward flux, downward flux, sun: each at factor 1
uniform vec4 surface;   // x: path radiance times (1 - t); y: opacity 1 - t, 0..1; z: N >= 0; w: row + 1
uniform vec3 zenithEye; // unit, eye space
uniform vec3 sunEye;    // unit, towards the sun

#if TRANSPARENT
layout(early_fragment_tests) in;
layout(std430, binding = 0) buffer Counter { uint count; };
// Radiance: (sample, depth, A_pre, opacity). Factors: that many twice, (sample, depth, row + 1, distance)
// and (thermal, down, sun, 0).
layout(std430, binding = 1) writeonly buffer Fragments { uvec4 fragments[]; };
uniform int capacity;    // entries that fit
uniform int rasterWidth; // samples
#elif PRODUCT == 0
layout(location = 0) out vec2 plane0; // A_pre, opacity
#else
layout(location = 0) out vec4 plane0; // row + 1, thermal, down, sun
#if PRODUCT == 2
layout(location = 1) out float plane1; // distance, m
#endif
#endif

float arcCosine(float x); // accurate.glsl
float power(float base, float exponent);

void main() {
    // The side that is seen is a fact of the winding; the normal is turned to it.
    vec3 normal = normalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);

#if ANGLE_MODE == 0
    float thermal = 1.0;
#else
    float thermal = clamp(-dot(normal, normalize(eyePosition)), 0.0, 1.0);
#if ANGLE_MODE == 2
    thermal = power(thermal, surface.z);
#endif
#endif

#if SUN_MODE == 0
    float sun = 0.0;
#elif SUN_MODE == 1
    float sun = 0.25;
#else
    float sun = max(dot(normal, sunEye), 0.0);
#endif

#if FLUX_MODE == 0
    float down = 0.0, up = 0.0;
#elif FLUX_MODE == 1
    float down = 0.5, up = 0.5;
#else
    float cosZenith = clamp(dot(normal, zenithEye), -1.0, 1.0);
#if FLUX_MODE == 2
    float down = 0.5 * (1.0 + cosZenith);
#else
    float down = 1.0 - arcCosine(cosZenith) / 3.14159265358979;
#endif
    float up = 1.0 - down;
#endif

#if PRODUCT == 0
    float apparent = thermal * radiance.x + up * radiance.y + down * radiance.z + sun * radiance.w +
                     surface.x;
#endif

#if TRANSPARENT
    uint place = atomicAdd(count, 1u);
    if (place >= uint(capacity))
        return;
    uint here = uint(gl_FragCoord.y) * uint(rasterWidth) + uint(gl_FragCoord.x);
    uint depth = floatBitsToUint(gl_FragCoord.z);
#if PRODUCT == 0
    fragments[place] = uvec4(here, depth, floatBitsToUint(apparent), floatBitsToUint(surface.y));
#else
    fragments[2u * place] = uvec4(here, depth, floatBitsToUint(surface.w),
                                  floatBitsToUint(length(eyePosition)));
    fragments[2u * place + 1u] = uvec4(floatBitsToUint(thermal), floatBitsToUint(down),
                                       floatBitsToUint(sun), 0u);
#endif
#elif PRODUCT == 0
    plane0 = vec2(apparent, surface.y);
#else
    plane0 = vec4(surface.w, thermal, down, sun);
#if PRODUCT == 2
    plane1 = length(eyePosition);
#endif
#endif
}
