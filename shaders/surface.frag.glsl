#version 330 compatibility
// Apparent radiance of one sample of a surface (docs/physics.md, equations 1 to 3), or its factors.
// All radiances are in-band, W m-2 sr-1, computed in double on the CPU.

in vec3 eyePosition;
in vec3 eyeNormal;

uniform vec4 radiance; // thermal, upward flux, downward flux, sun: each at factor 1
uniform vec4 surface;  // x: path radiance times (1 - t); y: opacity 1 - t, 0..1; z: N >= 0; w: row + 1
uniform vec3 zenithEye; // unit, eye space
uniform vec3 sunEye;    // unit, towards the sun
uniform int sunMode;    // 0 off, 1 independent of geometry, 2 per sample
uniform int fluxMode;   // 0 off, 1 independent of geometry, 2 view factors, 3 the report's angles
uniform int product;    // 0 radiance, 1 factors

uniform int peel;                // 0 opaque pass, 1 first layer, 2 any further layer
uniform sampler2D opaqueDepth;   // depth of the opaque surfaces: 1 near, 0 far or none
uniform sampler2D previousDepth; // depth of the layer before

layout(location = 0) out vec4 plane0; // radiance: (A_pre, 0, 0, alpha); factors: (row + 1, thermal, down, sun)
layout(location = 1) out vec4 plane1; // factors: (distance m, up, 0, 0)

float arcCosine(float x);           // accurate.glsl
float power(float base, float exponent);

void main() {
    if (peel > 0) {
        ivec2 here = ivec2(gl_FragCoord.xy);
        if (gl_FragCoord.z <= texelFetch(opaqueDepth, here, 0).r)
            discard;
        if (peel > 1 && gl_FragCoord.z >= texelFetch(previousDepth, here, 0).r)
            discard;
    }

    // The side that is seen is a fact of the winding; the normal is turned to it.
    vec3 normal = normalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    float distance = length(eyePosition);
    float cosView = clamp(-dot(normal, eyePosition) / distance, 0.0, 1.0);
    float cosZenith = clamp(dot(normal, zenithEye), -1.0, 1.0);

    float thermal = power(cosView, surface.z);
    float sun = sunMode == 0 ? 0.0 : sunMode == 1 ? 0.25 : max(dot(normal, sunEye), 0.0);
    float down = fluxMode == 0   ? 0.0
                 : fluxMode == 1 ? 0.5
                 : fluxMode == 2 ? 0.5 * (1.0 + cosZenith)
                                 : 1.0 - arcCosine(cosZenith) / 3.14159265358979;
    float up = fluxMode == 0 ? 0.0 : 1.0 - down;

    if (product == 1) {
        plane0 = vec4(surface.w, thermal, down, sun);
        plane1 = vec4(distance, up, 0.0, 0.0);
    } else {
        float apparent = thermal * radiance.x + up * radiance.y + down * radiance.z +
                         sun * radiance.w + surface.x;
        plane0 = vec4(apparent, 0.0, 0.0, surface.y);
        plane1 = vec4(0.0);
    }
}
