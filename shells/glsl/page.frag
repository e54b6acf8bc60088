// The light that reaches the eye: Eq. 15 to 17 of the book paper, under a room and a lamp.
//   f = k_d Lambert + k_s Cook-Torrance + k_t Lambert from behind
//   k_t = (1 - F) e^(-alpha t),  k_d = (1 - F)(1 - e^(-alpha t)),  k_s = F
// It follows the software renderer in shells/render function by function.
in vec3 worldPlace;
in vec3 worldNormal;
in vec2 pagePlace;

out vec4 colour;

// Where the eye is, metres; the picture, pixels; side of a pixel one metre away, metres.
uniform vec3 eye;
uniform vec2 picture;
uniform float pixelAtOneMetre;
// Light of the lamp, linear.
uniform vec3 lampColour;

// What the surface is: 0 paper, 1 the cut edges of leaves, 2 a board, 3 the table.
uniform int material;
// Linear colour of the bare surface.
uniform vec3 tint;
// Share of the light that passes the leaf, and the way through it, metres; 0 for all but a leaf in the air.
uniform float passing;
uniform float thickness;
// Leaves whose edges are seen; only for material 1.
uniform float leaves;

// The picture on this side and the one on the other, sRGB bytes read as they are; white where there is none.
uniform sampler2D front;
uniform sampler2D back;
// What grain.frag drew.
uniform sampler2D grain;
uniform sampler2DShadow lampMaps;
uniform sampler2DShadow skyMaps;

const float PI = 3.14159265;
// Mirrored share at normal incidence of an index of refraction of 1.5.
const float F0 = 0.04;
// A place that sees less than a third of the room lies in a slit finer than the lamp's maps.
const float DEEP = 3.0;
// Light of the room from straight below.
const float FLOOR = 0.31166;

// The room in nine real spherical harmonics.
const vec3 ROOM[9] = vec3[9](
    vec3(1.99292, 1.85117, 1.66442),
    vec3(0.59908, 0.61590, 0.62489),
    vec3(-0.28849, -0.27984, -0.26541),
    vec3(-0.42583, -0.41305, -0.39176),
    vec3(-0.30782, -0.29858, -0.28319),
    vec3(-0.20859, -0.20233, -0.19190),
    vec3(-0.13550, -0.13246, -0.12676),
    vec3(0.19588, 0.19000, 0.18021),
    vec3(-0.07824, -0.07766, -0.07560)
);

float roughness() {
    return material == 1 ? 0.9 : material == 2 ? 0.75 : 0.8;
}

vec3 room(vec3 d, vec3 bands) {
    vec3 sum = ROOM[0] * (0.282095 * bands.x);
    sum += (ROOM[1] * (0.488603 * d.y) + ROOM[2] * (0.488603 * d.z) + ROOM[3] * (0.488603 * d.x)) * bands.y;
    vec3 second = ROOM[4] * (1.092548 * d.x * d.y) + ROOM[5] * (1.092548 * d.y * d.z);
    second += ROOM[6] * (0.315392 * (3.0 * d.z * d.z - 1.0)) + ROOM[7] * (1.092548 * d.x * d.z);
    second += ROOM[8] * (0.546274 * (d.x * d.x - d.y * d.y));
    return max(sum + second * bands.z, vec3(0.0));
}

// Light a white, matte surface sends out.
vec3 irradiance(vec3 normal) {
    return room(normal, vec3(1.0, 2.0 / 3.0, 0.25));
}

// Light mirrored by a rough surface, before its Fresnel share.
vec3 mirrored(vec3 direction) {
    float a = roughness() * roughness();
    return room(direction, vec3(1.0, 1.0 / (1.0 + 0.5 * a), 1.0 / (1.0 + 1.5 * a)));
}

float schlick(float cosine) {
    float m = 1.0 - clamp(cosine, 0.0, 1.0);
    float m2 = m * m;
    return F0 + (1.0 - F0) * m2 * m2 * m;
}

// Mirrored share of the room: the second half of the split sum, as a fit.
float environmentShare(float nv) {
    vec4 r = vec4(-1.0, -0.0275, -0.572, 0.022) * roughness() + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    return clamp(F0 * (-1.04 * a + r.z) + (1.04 * a + r.w), 0.0, 1.0);
}

float smith(float nx, float alpha2) {
    float c = max(nx, 1e-4);
    return 2.0 * c / (c + sqrt(alpha2 + (1.0 - alpha2) * c * c));
}

// The Cook-Torrance lobe without its Fresnel share: D G / 4 (n.l)(n.v).
float lobe(float nl, float nv, float nh) {
    float alpha = max(roughness() * roughness(), 1e-3);
    float alpha2 = alpha * alpha;
    float d = nh * nh * (alpha2 - 1.0) + 1.0;
    float density = alpha2 / (PI * d * d);
    return density * smith(nl, alpha2) * smith(nv, alpha2) / (4.0 * max(nl, 1e-4) * max(nv, 1e-4));
}

// What is hidden from the room is not black: its neighbours are pale too and hand light on.
vec3 bounced(float open) {
    vec3 a = 2.0404 * tint - 0.3324;
    vec3 b = -4.7951 * tint + 0.6417;
    vec3 c = 2.7552 * tint + 0.6903;
    return max(((a * open + b) * open + c) * open, vec3(open));
}

// Share of the lamp that is seen from the side that faces it. The place is lifted off the surface, the
// more the flatter the light comes in; light from behind starts on the far side of the leaf.
float lampShare(vec3 face, vec3 towards, bool behind) {
    if (behind && passing <= 0.0) {
        return 0.0;
    }
    LampView view = lampView();
    float texel = dot(worldPlace - lamp.xyz, view.ahead) / view.plane * 2.0 * view.extent / LAMP_SIDE;
    vec3 side = behind ? -face : face;
    float slant = clamp(dot(side, towards), 0.0, 1.0);
    float lift = texel * (0.25 + 1.1 * sqrt(1.0 - slant * slant)) + (behind ? thickness : 0.0);
    vec3 d = worldPlace + side * lift - lamp.xyz;
    float z = dot(d, view.ahead);
    vec2 middle = vec2(dot(d, view.right), dot(d, view.up)) * (view.plane / z);
    float spread = lamp.w * (1.0 - view.plane / z);
    float depth = 0.5 + 0.5 * (view.a + view.b / max(z - 0.5 * texel, 1e-3));
    if (z < 1e-3) {
        return 1.0;
    }
    float inside = 1.0 - 2.0 / LAMP_SIDE;
    float sum = 0.0;
    float asked = 0.0;
    for (int k = 0; k < LAMP_MAPS; k++) {
        // Six points from all over the disc come first. Where they agree there is no penumbra.
        if (k == 6 && (sum == 0.0 || sum == 6.0)) {
            break;
        }
        int i = k * 3 % LAMP_MAPS;
        vec2 at = (middle + DISC[i] * spread) / view.extent;
        asked += 1.0;
        if (max(abs(at.x), abs(at.y)) < inside) {
            vec2 tile = vec2(float(i % LAMP_ACROSS), float(i / LAMP_ACROSS));
            vec2 place = (tile + 0.5 + 0.5 * at) / float(LAMP_ACROSS);
            sum += textureLod(lampMaps, vec3(place, depth), 0.0);
        } else {
            sum += 1.0;
        }
    }
    float share = sum / asked;
    // The first and the last point would each draw a line along the penumbra's ends.
    return share * share * (3.0 - 2.0 * share);
}

float skyShareOf(vec4 sum, float floorLight) {
    float openness = sum.z > 0.0 ? 0.35 + 0.65 * sum.w / sum.z : 0.6;
    return (sum.y + floorLight * openness) / max(sum.x + floorLight, 1e-6);
}

// Shares of the room that the near side and the far side see.
vec2 skyShare(vec3 normal, vec3 face) {
    float texel = 2.0 * bound.w / SKY_SIDE;
    if (distance(worldPlace, bound.xyz) > 4.0 * bound.w) {
        return vec2(1.0);
    }
    vec3 near = worldPlace + face * (0.35 * texel);
    vec3 far = worldPlace - face * (thickness + 0.35 * texel);
    // What gets in, what of it is not in the way; how many were asked, how many are open.
    vec4 lit = vec4(0.0);
    vec4 behind = vec4(0.0);
    float inside = 1.0 - 2.0 / SKY_SIDE;
    for (int i = 0; i < SKY_MAPS; i++) {
        float slant = dot(normal, SKY[i].xyz);
        bool faces = slant > 0.0;
        if (!faces && passing <= 0.0) {
            continue;
        }
        vec3 at = skyPlace(faces ? near : far, i);
        float open = 1.0;
        if (max(abs(at.x), abs(at.y)) < inside) {
            vec2 tile = vec2(float(i % SKY_ACROSS), float(i / SKY_ACROSS));
            vec2 place = (tile + 0.5 + 0.5 * at.xy) / vec2(float(SKY_ACROSS), float(SKY_DOWN));
            // What stands out by less than half a texel hides nothing: the maps are coarse.
            float depth = 0.5 - 0.5 * at.z - 0.5 / SKY_SIDE;
            open = textureLod(skyMaps, vec3(place, clamp(depth, 0.0, 1.0)), 0.0);
        }
        float weight = abs(slant) * SKY[i].w;
        vec4 one = vec4(weight, weight * open, 1.0, open);
        lit += faces ? one : vec4(0.0);
        behind += faces ? vec4(0.0) : one;
    }
    float below = FLOOR * float(SKY_MAPS) * 0.25;
    return vec2(
        skyShareOf(lit, below * (1.0 - normal.y)),
        skyShareOf(behind, below * (1.0 + normal.y))
    );
}

vec3 decoded(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

// Linear colour of what the pixel covers of the page. A page bent away from the eye squeezes its print in
// one direction only: the level is chosen by the short side, the long side is averaged.
vec3 printed(vec2 dx, vec2 dy) {
    vec2 size = vec2(textureSize(front, 0));
    vec2 px = dx * size;
    vec2 py = dy * size;
    bool wide = dot(px, px) > dot(py, py);
    vec2 way = wide ? dx : dy;
    float l = sqrt(max(dot(px, px), dot(py, py)));
    float s = max(sqrt(min(dot(px, px), dot(py, py))), 1e-6);
    float taps = max(ceil(min(min(l / s, 8.0), max(l, 1.0)) - 0.4), 1.0);
    float level = max(log2(max(max(l / taps, min(s, l)), 1e-6)) - 0.35, 0.0);
    vec2 at = pagePlace - way * (0.5 * (taps - 1.0) / taps);
    // Two levels are blended as light; what is close to one reads only that one.
    float fine = floor(level);
    float blend = clamp((level - fine - 0.2) / 0.6, 0.0, 1.0);
    vec3 sum = vec3(0.0);
    for (float i = 0.0; i < taps; i += 1.0) {
        vec3 near = decoded(textureLod(front, at, fine).rgb);
        sum += blend > 0.0 ? mix(near, decoded(textureLod(front, at, fine + 1.0).rgb), blend) : near;
        at += way / taps;
    }
    return sum / taps;
}

// The other side's picture, seen through the leaf: paper blurs it, the plain filter will do.
vec3 printBehind(vec2 dx, vec2 dy) {
    vec2 size = vec2(textureSize(back, 0));
    vec2 px = dx * size;
    vec2 py = dy * size;
    float texels = sqrt(max(dot(px, px), dot(py, py)));
    float level = floor(log2(max(texels, 1.0)));
    return decoded(textureLod(back, vec2(1.0 - pagePlace.x, pagePlace.y), level).rgb);
}

// How much of a pattern survives a pixel: 1 fine, 0 averaged away.
float survives(float period, float pixel) {
    return clamp(period / (2.0 * max(pixel, 1e-9)) - 0.5, 0.0, 1.0);
}

// Cut leaves, as noise across the stack in octaves, from single leaves to whole quires. An octave finer
// than a pixel fades to its mean.
float edges(vec2 dx, vec2 dy) {
    float pixel = max(abs(dx.y), abs(dy.y)) * leaves;
    float place = pagePlace.y * leaves + 1.2 * (value(pagePlace.x * 9.0, pagePlace.y * 6.0) - 0.5);
    float leaf = floor(place);
    float width = 0.25 + 0.5 * hash(int(leaf), 3);
    float gap = clamp((abs(place - leaf - 0.5) * 2.0 - (1.0 - width)) / width, 0.0, 1.0) * survives(1.0, pixel);
    float shade = 0.0;
    float period = 1.0;
    for (int octave = 0; octave < 7; octave++) {
        float weight = 0.15 * survives(2.0 * period, pixel);
        float along = pagePlace.x * (14.0 / (1.0 + float(octave)));
        shade += weight * (value(place / period, along + 17.0 * float(octave)) - 0.5);
        period *= 2.0;
    }
    return 0.90 + shade - 0.20 * gap;
}

// Woven cloth: threads where the pixel is small enough to see them.
float cloth(float pixel) {
    const float THREAD = 0.0012;
    float x = worldPlace.x + worldPlace.y;
    float z = worldPlace.z + worldPlace.y;
    float weave = sin(x * (2.0 * PI / THREAD)) * sin(z * (2.0 * PI / THREAD));
    float slub = value(x * 900.0, z * 160.0) + value(x * 160.0 + 40.0, z * 900.0) - 1.0;
    float worn = value(x * 35.0, z * 35.0) - 0.5;
    return 1.0 + 0.10 * survives(THREAD, pixel) * weave + 0.16 * survives(0.0022, pixel) * slub + 0.08 * worn;
}

float folded(float place) {
    return 1.0 - abs(2.0 * fract(0.5 * place + 0.18) - 1.0);
}

vec3 wood(float pixel) {
    vec2 at = vec2(folded(worldPlace.x / 1.6), folded(worldPlace.z / 0.8));
    float texels = pixel * 1536.0 / 0.8;
    return decoded(textureLod(grain, at, floor(log2(max(texels, 1.0)))).rgb) * 4.0;
}

// Compresses what is brighter than the knee, so that nothing clips hard.
float shoulder(float light) {
    const float KNEE = 0.72;
    float above = 1.0 - KNEE;
    return light <= KNEE ? max(light, 0.0) : KNEE + above * (1.0 - exp((KNEE - light) / above));
}

float byteOf(float light) {
    float c = shoulder(light);
    return 255.0 * (c <= 0.0031308 ? c * 12.92 : 1.055 * pow(c, 1.0 / 2.4) - 0.055);
}

// An ordered pattern of a quarter level each way hides banding and stands still.
float pattern(ivec2 at) {
    const int BAYER[16] = int[16](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);
    return 0.25 + float(BAYER[(at.y & 3) * 4 + (at.x & 3)]) / 30.0;
}

vec3 toned(vec3 light) {
    vec2 place = vec2(gl_FragCoord.x, picture.y - gl_FragCoord.y);
    vec2 off = place - 0.5 * picture;
    light *= 1.0 - 0.22 * dot(off, off) / (0.25 * dot(picture, picture));
    vec3 bytes = vec3(byteOf(light.r), byteOf(light.g), byteOf(light.b));
    return floor(bytes + pattern(ivec2(place))) / 255.0;
}

void main() {
    vec2 dx = dFdx(pagePlace);
    vec2 dy = dFdy(pagePlace);
    vec3 view = normalize(eye - worldPlace);
    vec3 face = cross(dFdx(worldPlace), dFdy(worldPlace));
    face = dot(face, face) > 1e-30 ? normalize(face) : normalize(worldNormal);
    face *= dot(face, view) < 0.0 ? -1.0 : 1.0;
    vec3 normal = normalize(worldNormal);
    float ahead = 1.0 / gl_FragCoord.w;
    float pixel = ahead * pixelAtOneMetre;

    vec3 albedo = tint;
    vec3 through = vec3(0.0);
    if (material == 0) {
        albedo *= printed(dx, dy);
        through = passing > 0.0 ? tint * albedo * printBehind(dx, dy) : vec3(0.0);
    } else if (material == 1) {
        albedo *= edges(dx, dy);
    } else if (material == 2) {
        albedo *= cloth(pixel);
    } else {
        albedo *= wood(pixel);
    }

    // The room.
    vec2 sky = skyShare(normal, face);
    float nv = max(dot(normal, view), 0.05);
    float fresnel = environmentShare(nv);
    vec3 diffuse = irradiance(normal) * bounced(sky.x) * ((1.0 - fresnel) * (1.0 - passing));
    vec3 gloss = mirrored(normal * (2.0 * nv) - view) * (fresnel * sky.x * sky.x);
    vec3 passed = irradiance(-normal) * bounced(sky.y) * ((1.0 - fresnel) * passing);

    // The lamp. A leaf lit from behind shines by what passes through it.
    vec3 way = lamp.xyz - worldPlace;
    float d2 = max(dot(way, way), 1e-6);
    vec3 towards = way * inversesqrt(d2);
    float nl = dot(normal, towards);
    float seen = lampShare(face, towards, nl < 0.0) * min((nl < 0.0 ? sky.y : sky.x) * DEEP, 1.0);
    vec3 falling = lampColour * (abs(nl) * seen / (PI * d2));
    float mirror = schlick(abs(nl));
    if (nl < 0.0) {
        passed += falling * ((1.0 - mirror) * passing);
    } else {
        vec3 middle = normalize(towards + view);
        diffuse += falling * ((1.0 - mirror) * (1.0 - passing));
        float glint = lobe(nl, nv, max(dot(normal, middle), 0.0));
        gloss += falling * (schlick(dot(middle, towards)) * glint * PI);
    }
    colour = vec4(toned(albedo * diffuse + through * passed + gloss), 1.0);
}
