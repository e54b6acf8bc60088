// The casters as one map of the lamp or of the sky sees them.
layout(location = 0) in vec3 position;

// Which map: the lamp's 16, then the sky's 32.
uniform int map;

void main() {
    if (map < LAMP_MAPS) {
        gl_Position = lampClip(position, map);
    } else {
        vec3 place = skyPlace(position, map - LAMP_MAPS);
        gl_Position = vec4(place.xy, -place.z, 1.0);
    }
}
