#version 300 es
// What every stage shares: the lamp's and the sky's shadow maps. It stands before each of the other
// files: a shader's source is this file and then that one.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DShadow;

// A sphere around all that casts shadows: centre and radius, metres.
uniform vec4 bound;
// Centre of the lamp, metres, and the radius of its disc.
uniform vec4 lamp;

// The lamp's maps: 16 tiles of 512 texels, four by four. One tile for each point of its disc.
const int LAMP_MAPS = 16;
const int LAMP_ACROSS = 4;
const float LAMP_SIDE = 512.0;
// The sky's maps: 32 tiles of 192 texels, eight by four. One tile for each direction.
const int SKY_MAPS = 32;
const int SKY_ACROSS = 8;
const int SKY_DOWN = 4;
const float SKY_SIDE = 192.0;

// Points of the disc, in its radius: spread evenly; with their surroundings they stay inside it.
const vec2 DISC[16] = vec2[16](
    vec2(0.15026, 0.00000), vec2(-0.19191, 0.17580), vec2(0.02937, -0.33471), vec2(0.24189, 0.31550),
    vec2(-0.44389, -0.07852), vec2(0.42049, -0.26748), vec2(-0.14065, 0.52320), vec2(-0.26823, -0.51646),
    vec2(0.58195, 0.21253), vec2(-0.60542, 0.24991), vec2(0.29185, -0.62367), vec2(0.21567, 0.68759),
    vec2(-0.65003, -0.37671), vec2(0.76256, -0.16765), vec2(-0.46538, 0.66196), vec2(-0.10751, -0.82968)
);

// Directions of the sky, spread evenly above the table, and how bright the room is there.
const vec4 SKY[32] = vec4[32](
    vec4(0.99347, 0.11406, 0.00000, 0.32346),
    vec4(-0.72988, 0.14219, 0.66863, 0.50080),
    vec4(0.08615, 0.17031, -0.98162, 0.63152),
    vec4(0.59634, 0.19844, 0.77782, 0.33510),
    vec4(-0.95911, 0.22656, -0.16965, 0.92703),
    vec4(0.81593, 0.25469, -0.51903, 0.36492),
    vec4(-0.24901, 0.28281, 0.92629, 0.38683),
    vec4(-0.43806, 0.31094, -0.84346, 0.95246),
    vec4(0.88368, 0.33906, 0.32272, 0.34297),
    vec4(-0.85978, 0.36719, 0.35490, 0.77350),
    vec4(0.38932, 0.39531, -0.83196, 0.59086),
    vec4(0.27113, 0.42344, 0.86440, 0.36294),
    vec4(-0.77198, 0.45156, -0.44738, 1.11056),
    vec4(0.85697, 0.47969, -0.18840, 0.39090),
    vec4(-0.49546, 0.50781, 0.70473, 0.59294),
    vec4(-0.10850, 0.53594, -0.83726, 0.92711),
    vec4(0.63140, 0.56406, 0.53214, 0.38486),
    vec4(-0.80511, 0.59219, 0.03329, 1.03777),
    vec4(0.55597, 0.62031, -0.55327, 0.58187),
    vec4(-0.03516, 0.64844, 0.76046, 0.50355),
    vec4(-0.47181, 0.67656, -0.56538, 1.15900),
    vec4(0.70318, 0.70469, 0.09461, 0.46044),
    vec4(-0.55854, 0.73281, 0.38862, 0.86416),
    vec4(0.14240, 0.76094, -0.63300, 0.88058),
    vec4(0.30543, 0.78906, 0.53301, 0.51877),
    vec4(-0.54911, 0.81719, -0.17518, 1.15890),
    vec4(0.48501, 0.84531, -0.22409, 0.65375),
    vec4(-0.18799, 0.87344, 0.44919, 0.76149),
    vec4(-0.14643, 0.90156, -0.40712, 1.07395),
    vec4(0.32606, 0.92969, 0.17137, 0.66331),
    vec4(-0.27790, 0.95781, 0.07325, 1.00406),
    vec4(0.09038, 0.98594, -0.14056, 0.90235)
);
const vec3 SKY_RIGHT[32] = vec3[32](
    vec3(-0.11406, 0.99347, 0.00000),
    vec3(-0.19122, -0.98155, 0.00000),
    vec3(-0.00000, 0.98528, 0.17095),
    vec3(0.00000, -0.96896, 0.24720),
    vec3(-0.22990, -0.97322, 0.00000),
    vec3(-0.29796, 0.95458, 0.00000),
    vec3(0.00000, -0.95642, 0.29201),
    vec3(-0.00000, 0.93827, 0.34589),
    vec3(-0.35823, 0.93363, 0.00000),
    vec3(-0.39275, -0.91964, 0.00000),
    vec3(-0.00000, 0.90322, 0.42917),
    vec3(0.00000, -0.89804, 0.43992),
    vec3(-0.50491, -0.86317, 0.00000),
    vec3(-0.48843, 0.87260, 0.00000),
    vec3(0.00000, -0.81131, 0.58461),
    vec3(-0.00000, 0.84223, 0.53912),
    vec3(0.00000, -0.68622, 0.72739),
    vec3(-0.59252, -0.80556, 0.00000),
    vec3(-0.00000, 0.66563, 0.74629),
    vec3(0.00000, -0.76093, 0.64884),
    vec3(-0.00000, 0.64124, 0.76734),
    vec3(-0.70786, 0.70635, 0.00000),
    vec3(0.00000, -0.46851, 0.88346),
    vec3(-0.00000, 0.63952, 0.76877),
    vec3(0.00000, -0.55975, 0.82866),
    vec3(-0.00000, 0.20961, 0.97779),
    vec3(-0.00000, 0.25624, 0.96661),
    vec3(0.00000, -0.45734, 0.88929),
    vec3(-0.00000, 0.41155, 0.91139),
    vec3(0.00000, -0.18127, 0.98343),
    vec3(0.00000, -0.07626, 0.99709),
    vec3(-0.00000, 0.14114, 0.98999)
);

// How the lamp sees: all maps share one plane of projection through the middle of the sphere, parallel
// to the disc. A point o of the disc sees a place of distance z at c + o (1 - D/z), if its centre sees it at c.
struct LampView {
    vec3 ahead;
    vec3 right;
    vec3 up;
    // Distance of the plane, and half the side of a map on it, metres.
    float plane;
    float extent;
    // Depth of a map is a + b / z, from -1 to 1 through the sphere.
    float a;
    float b;
};

LampView lampView() {
    vec3 way = bound.xyz - lamp.xyz;
    float plane = length(way);
    vec3 ahead = way / plane;
    vec3 aside = abs(ahead.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0);
    vec3 right = normalize(cross(aside, ahead));
    float radius = min(bound.w, 0.9 * plane);
    float near = plane - radius;
    float far = plane + radius;
    float cone = plane * radius / sqrt(plane * plane - radius * radius);
    float extent = (cone + lamp.w * (plane / near - 1.0)) * (1.0 + 4.0 / LAMP_SIDE);
    float a = (far + near) / (far - near);
    float b = -2.0 * far * near / (far - near);
    return LampView(ahead, right, cross(right, ahead), plane, extent, a, b);
}

// Clip space of the lamp's map i.
vec4 lampClip(vec3 place, int i) {
    LampView view = lampView();
    vec3 d = place - lamp.xyz;
    float z = dot(d, view.ahead);
    vec2 seen = vec2(dot(d, view.right), dot(d, view.up)) * view.plane;
    seen += DISC[i] * (lamp.w * (z - view.plane));
    return vec4(seen / view.extent, view.a * z + view.b, z);
}

// Place in the sky's map i, -1 to 1 each way; the third grows towards the light.
vec3 skyPlace(vec3 place, int i) {
    vec3 towards = SKY[i].xyz;
    vec3 right = SKY_RIGHT[i];
    vec3 d = (place - bound.xyz) / (bound.w * (1.0 + 4.0 / SKY_SIDE));
    return vec3(dot(d, right), dot(d, cross(towards, right)), dot(d, towards));
}

// A number in 0..1 that looks random for a lattice place.
float hash(int x, int y) {
    uint h = (uint(x) * 0x9e3779b1u) ^ (uint(y) * 0x85ebca77u);
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return float(h >> 8) / 16777216.0;
}

// Smooth noise in 0..1 with one feature a unit.
float value(float x, float y) {
    float fx = floor(x);
    float fy = floor(y);
    int ix = int(fx);
    int iy = int(fy);
    float tx = x - fx;
    float ty = y - fy;
    tx = tx * tx * (3.0 - 2.0 * tx);
    ty = ty * ty * (3.0 - 2.0 * ty);
    float top = mix(hash(ix, iy), hash(ix + 1, iy), tx);
    float bottom = mix(hash(ix, iy + 1), hash(ix + 1, iy + 1), tx);
    return mix(top, bottom, ty);
}
