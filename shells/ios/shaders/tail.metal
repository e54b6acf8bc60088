// A corner of the mesh as the core keeps it: 32 bytes.
struct Corner {
    packed_float3 position;
    packed_float3 normal;
    packed_float2 uv;
};

// True for a whole frame; `FrameUniforms` in Swift.
struct FrameUniforms {
    float4x4 clipFromWorld;
    float4 bound;
    float4 lamp;
    float4 lampColour;
    float4 eye;
    float2 picture;
    float pixelAtOneMetre;
    float unused;
};

// True for a piece; `PieceUniforms` in Swift.
struct PieceUniforms {
    float4 tint;
    int material;
    float passing;
    float thickness;
    float leaves;
};

// Depth runs from 0 to 1 here, from -1 to 1 in GLSL.
static inline float4 clipped(float4 place) {
    return float4(place.xy, 0.5 * (place.z + place.w), place.w);
}

struct PageStage {
    float4 position [[position]];
    float3 worldPlace;
    float3 worldNormal;
    float2 pagePlace;
};

vertex PageStage page_vertex(
    uint id [[vertex_id]],
    const device Corner *corners [[buffer(0)]],
    constant FrameUniforms &frame [[buffer(1)]]
) {
    page_vert::Shading s;
    s.position = float3(corners[id].position);
    s.normal = float3(corners[id].normal);
    s.uv = float2(corners[id].uv);
    s.clipFromWorld = frame.clipFromWorld;
    s.run();
    PageStage out;
    out.position = clipped(s.gl_Position);
    out.worldPlace = s.worldPlace;
    out.worldNormal = s.worldNormal;
    out.pagePlace = s.pagePlace;
    return out;
}

fragment float4 page_fragment(
    PageStage in [[stage_in]],
    constant FrameUniforms &frame [[buffer(1)]],
    constant PieceUniforms &piece [[buffer(2)]],
    texture2d<float> front [[texture(0)]],
    texture2d<float> back [[texture(1)]],
    texture2d<float> grain [[texture(2)]],
    depth2d<float> lampMaps [[texture(3)]],
    depth2d<float> skyMaps [[texture(4)]]
) {
    page_frag::Shading s;
    s.bound = frame.bound;
    s.lamp = frame.lamp;
    s.lampColour = frame.lampColour.xyz;
    s.eye = frame.eye.xyz;
    s.picture = frame.picture;
    s.pixelAtOneMetre = frame.pixelAtOneMetre;
    s.material = piece.material;
    s.tint = piece.tint.xyz;
    s.passing = piece.passing;
    s.thickness = piece.thickness;
    s.leaves = piece.leaves;
    s.front = front;
    s.back = back;
    s.grain = grain;
    s.lampMaps = lampMaps;
    s.skyMaps = skyMaps;
    s.worldPlace = in.worldPlace;
    s.worldNormal = in.worldNormal;
    s.pagePlace = in.pagePlace;
    // The picture's rows are counted from above here, from below in GLSL.
    s.gl_FragCoord = float4(in.position.x, frame.picture.y - in.position.y, in.position.z, in.position.w);
    s.run();
    return s.colour;
}

struct DepthStage {
    float4 position [[position]];
};

vertex DepthStage shadow_vertex(
    uint id [[vertex_id]],
    const device Corner *corners [[buffer(0)]],
    constant FrameUniforms &frame [[buffer(1)]],
    constant int &map [[buffer(2)]]
) {
    shadow_vert::Shading s;
    s.position = float3(corners[id].position);
    s.bound = frame.bound;
    s.lamp = frame.lamp;
    s.map = map;
    s.run();
    float4 place = clipped(s.gl_Position);
    DepthStage out;
    // A texture's first row is the lowest in GLSL, and the map is read by its formulas.
    out.position = float4(place.x, -place.y, place.z, place.w);
    return out;
}

vertex DepthStage grain_vertex(uint id [[vertex_id]]) {
    grain_vert::Shading s;
    s.gl_VertexID = int(id);
    s.run();
    DepthStage out;
    out.position = clipped(s.gl_Position);
    return out;
}

fragment float4 grain_fragment(DepthStage in [[stage_in]]) {
    grain_frag::Shading s;
    s.gl_FragCoord = in.position;
    s.run();
    return s.colour;
}
