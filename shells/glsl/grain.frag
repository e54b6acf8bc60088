// The wood of the table, drawn once into a picture: computing its layers at every pixel would cost more
// than the light on it. It runs along X, so that it leads the eye past the book.
out vec4 colour;

// Size of the picture, texels, and on the table, metres.
const vec2 SIZE = vec2(192.0, 1536.0);
const vec2 PATCH = vec2(1.6, 0.8);

float layer(vec2 at, float perMetre, float stretch, float seed) {
    return value(at.x * perMetre / stretch + seed, at.y * perMetre + seed) - 0.5;
}

// A quarter of the light, so that bright streaks fit into a byte, as sRGB.
float encoded(float light) {
    float c = 0.25 * light;
    return c <= 0.0031308 ? c * 12.92 : 1.055 * pow(c, 1.0 / 2.4) - 0.055;
}

void main() {
    vec2 at = gl_FragCoord.xy / SIZE * PATCH;
    at.y += 0.016 * (value(at.x * 2.3, at.y * 7.0) - 0.5) + 0.005 * (value(at.x * 7.0, at.y * 24.0) - 0.5);
    float broad = layer(at, 14.0, 9.0, 3.0);
    float rings = layer(at, 70.0, 34.0, 7.0);
    float fibres = layer(at, 260.0, 60.0, 11.0) + 0.7 * layer(at, 700.0, 90.0, 29.0);
    float pores = max(layer(at, 900.0, 26.0, 41.0) - 0.22, 0.0);
    float light = 1.0 + 0.34 * broad + 0.30 * rings + 0.22 * fibres - 0.9 * pores;
    // Darker wood is redder.
    float warmth = 0.10 * (broad + rings);
    vec3 wood = vec3(1.0 - 0.5 * warmth, 1.0, 1.0 + warmth) * light;
    colour = vec4(encoded(wood.r), encoded(wood.g), encoded(wood.b), 1.0);
}
