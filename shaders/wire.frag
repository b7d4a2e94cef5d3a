#version 330 core
// Colours a line with soft sides, or a face (half_width 0), at its true depth.
uniform vec4 color;
uniform float half_width; // pixels
uniform float far;        // distance at depth 1
uniform int parallel;     // orthographic: nearness is the distance

in float across;
in float nearness;
out vec4 pixel;

void main()
{
    float cover = half_width > 0.0 ? clamp(half_width + 0.5 - abs(across), 0.0, 1.0) : 1.0 - across;
    gl_FragDepth = (parallel != 0 ? nearness : 1.0 / nearness) / far;
    pixel = vec4(color.rgb, color.a * cover);
}
