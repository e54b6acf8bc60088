#include <metal_stdlib>
using namespace metal;

// What GLSL calls otherwise, or answers for more shapes of arguments.

static inline float inversesqrt(float x) {
    return rsqrt(x);
}

static inline float2 dFdx(float2 v) {
    return dfdx(v);
}

static inline float3 dFdx(float3 v) {
    return dfdx(v);
}

// GLSL counts rows from below.
static inline float2 dFdy(float2 v) {
    return -dfdy(v);
}

static inline float3 dFdy(float3 v) {
    return -dfdy(v);
}

static inline float3 mix(float3 a, float3 b, float share) {
    return mix(a, b, float3(share));
}

static inline float3 step(float edge, float3 v) {
    return step(float3(edge), v);
}

static inline int2 textureSize(texture2d<float> of, int lod) {
    return int2(int(of.get_width(uint(lod))), int(of.get_height(uint(lod))));
}

static inline float4 textureLod(texture2d<float> of, float2 at, float lod) {
    constexpr sampler smooth(filter::linear, mip_filter::linear, address::clamp_to_edge);
    return of.sample(smooth, at, level(lod));
}

// Share of the four texels around `at.xy` that lie at `at.z` or behind it.
static inline float textureLod(depth2d<float> of, float3 at, float lod) {
    constexpr sampler compare(filter::linear, address::clamp_to_edge, compare_func::less_equal);
    return of.sample_compare(compare, at.xy, at.z, level(lod));
}
