// How a receiver reads a Lixel shadow map. Included by every receiver program.
//
// A map coordinate is (u w, v w, w, depth), affine in world space: u and v are texture coordinates,
// depth is what casters store. w <= 0 means that the light ray is not in the map.
//
// Define LIXEL_BILINEAR for percentage closer filtering over the 2x2 nearest texels; otherwise one
// nearest texel decides.

uniform sampler2D shadowMap;
// (width, height, depth bias, depth per world unit)
uniform vec4 lixelSizeBias;

// Change of depth for one texel of u and v along the receiver's own surface (Isidoro 2006,
// "receiver plane depth bias"), from the coordinate's screen derivatives.
vec2 lixelDepthSlope(vec4 coordinate)
{
    vec4 dx = dFdx(coordinate);
    vec4 dy = dFdy(coordinate);
    // d(u) = (d(u w) - u d(w)) / w
    vec2 uv = coordinate.xy / coordinate.z;
    vec2 tx = (dx.xy - uv * dx.z) / coordinate.z * lixelSizeBias.xy;
    vec2 ty = (dy.xy - uv * dy.z) / coordinate.z * lixelSizeBias.xy;
    float determinant = tx.x * ty.y - tx.y * ty.x;
    vec2 slope = vec2(ty.y * dx.w - tx.y * dy.w, tx.x * dy.w - ty.x * dx.w) / determinant;
    // A surface seen exactly edge-on has no slope in the map.
    return determinant != 0.0 ? slope : vec2(0.0);
}

// 1 where the light reaches the receiver through this texel, else 0.
float lixelTap(vec2 texel, vec2 position, float depth, vec2 slope)
{
    vec2 last = lixelSizeBias.xy - 1.0;
    float stored = texelFetch(shadowMap, ivec2(clamp(texel, vec2(0.0), last)), 0).r;
    // The receiver's surface where the light ray through the texel's centre meets it. A caster's
    // depth is at most 1: nothing is stored beyond the farthest receiver.
    float surface = depth + dot(slope, texel + 0.5 - position);
    return min(surface, 1.0) - lixelSizeBias.z <= stored ? 1.0 : 0.0;
}

// 1 where the receiver is lit, 0 where it is in shadow.
float lixelVisibility(vec4 coordinate)
{
    // Before any branch: derivatives are undefined in divergent flow.
    vec2 slope = lixelDepthSlope(coordinate);
    vec2 uv = coordinate.xy / coordinate.z;
    if (!(coordinate.z > 0.0) || any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0))))
        return 1.0;
    vec2 position = uv * lixelSizeBias.xy;
#ifdef LIXEL_BILINEAR
    vec2 corner = floor(position - 0.5);
    vec2 weight = position - 0.5 - corner;
    float v00 = lixelTap(corner, position, coordinate.w, slope);
    float v10 = lixelTap(corner + vec2(1.0, 0.0), position, coordinate.w, slope);
    float v01 = lixelTap(corner + vec2(0.0, 1.0), position, coordinate.w, slope);
    float v11 = lixelTap(corner + vec2(1.0, 1.0), position, coordinate.w, slope);
    return mix(mix(v00, v10, weight.x), mix(v01, v11, weight.x), weight.y);
#else
    return lixelTap(floor(position), position, coordinate.w, slope);
#endif
}
