#version 430 compatibility
// Apparent radiance of one sample of a surface (docs/physics.md, equations 1 to 3), or its factors.
// All radiances are in-band, W m-2 sr-1, computed in double on the CPU.
//
// The lines before this text come from irsg/radiance/RadianceTerms.cpp, the one list of what a
// surface can send: the frame's directions, FACTOR_COUNT (1 to 7) and FILL_FACTORS(f), which sets
// every factor. Compiled once for each combination of what a drawing needs:
//   PRODUCT     0 radiance, where nothing is transparent; 1 factors, 2 factors and distance
//   ANGLE_MODE  0: N = 0, 1: N = 1, 2: any N
//   TRANSPARENT 0: the nearest surface is drawn, 1: every surface before it is appended to a list

in vec3 eyePosition; // m, not normalised
in vec3 eyeNormal;   // any length

uniform vec4 surface; // x: radiance at every factor; y: opacity 1 - t, 0..1; z: N >= 0; w: row + 1
uniform float radiance[FACTOR_COUNT]; // added for each factor at 1

// Factors lie in vectors of four behind (row + 1) and distance in a list, behind row + 1 in planes.
#define LIST_VECTORS ((FACTOR_COUNT + 3) / 4)

#if TRANSPARENT
layout(early_fragment_tests) in;
layout(std430, binding = 0) buffer Counter { uint count; };
// (sample, depth, row + 1, distance) and the factors, four in a vector.
layout(std430, binding = 1) writeonly buffer Fragments { uvec4 fragments[]; };
uniform int capacity;    // entries that fit
uniform int rasterWidth; // samples
#elif PRODUCT == 0
layout(location = 0) out vec2 plane0; // A_pre, opacity
#else
layout(location = 0) out vec4 plane0; // row + 1, first three factors
#if FACTOR_COUNT > 3
layout(location = 1) out vec4 plane1; // the next four
#endif
#if PRODUCT == 2 && FACTOR_COUNT > 3
layout(location = 2) out float planeOfDistance; // m
#elif PRODUCT == 2
layout(location = 1) out float planeOfDistance; // m
#endif
#endif

float arcCosine(float x); // accurate.glsl
float power(float base, float exponent);

// |cos theta_view|^N.
float viewPower(vec3 normal, vec3 eyePosition, float n) {
#if ANGLE_MODE == 0
    return 1.0;
#else
    float cosView = clamp(-dot(normal, normalize(eyePosition)), 0.0, 1.0);
#if ANGLE_MODE == 2
    return power(cosView, n);
#else
    return cosView;
#endif
#endif
}

// What a facet sees of the sky: its view factor, or the report's 1 - theta_z / pi.
float viewWeight(float cosZenith) {
    return 0.5 * (1.0 + clamp(cosZenith, -1.0, 1.0));
}
float angleWeight(float cosZenith) {
    return 1.0 - arcCosine(clamp(cosZenith, -1.0, 1.0)) / 3.14159265358979;
}

void main() {
    // The side that is seen is a fact of the winding; the normal is turned to it.
    vec3 normal = normalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    float nAngleFactor = surface.z;
    float f[8];
    for (int i = 0; i < 8; ++i)
        f[i] = 0.0;
    FILL_FACTORS(f)

#if PRODUCT == 0
    float apparent = surface.x;
    for (int i = 0; i < FACTOR_COUNT; ++i)
        apparent += f[i] * radiance[i];
#endif

#if TRANSPARENT
    uint place = atomicAdd(count, 1u);
    if (place >= uint(capacity))
        return;
    uint here = uint(gl_FragCoord.y) * uint(rasterWidth) + uint(gl_FragCoord.x);
    uint depth = floatBitsToUint(gl_FragCoord.z);
    uint entry = place * uint(1 + LIST_VECTORS);
    fragments[entry] = uvec4(here, depth, floatBitsToUint(surface.w),
                             floatBitsToUint(length(eyePosition)));
    fragments[entry + 1u] = floatBitsToUint(vec4(f[0], f[1], f[2], f[3]));
#if FACTOR_COUNT > 4
    fragments[entry + 2u] = floatBitsToUint(vec4(f[4], f[5], f[6], f[7]));
#endif
#elif PRODUCT == 0
    plane0 = vec2(apparent, surface.y);
#else
    plane0 = vec4(surface.w, f[0], f[1], f[2]);
#if FACTOR_COUNT > 3
    plane1 = vec4(f[3], f[4], f[5], f[6]);
#endif
#if PRODUCT == 2
    planeOfDistance = length(eyePosition);
#endif
#endif
}
