// Places a corner in the picture.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;

uniform mat4 clipFromWorld;

out vec3 worldPlace;
out vec3 worldNormal;
out vec2 pagePlace;

void main() {
    worldPlace = position;
    worldNormal = normal;
    pagePlace = uv;
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
