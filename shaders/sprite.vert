#version 330 core
// One triangle per particle, made here from the vertex number: it encloses the circle in which the
// cone of rays from the eye touches the sphere, so it covers exactly what perspective shows of it.
uniform usamplerBuffer particles; // bits of x, y, z (float), then t (float) or RGBA8
uniform sampler1D map;
uniform mat4 view;                // to camera axes, looking along -z
uniform vec2 scale;               // 1 / tan of half the picture's angles, or 1 / half its sides
uniform int parallel;             // orthographic
uniform float radius;
uniform int solid;

flat out vec3 center;
flat out vec3 color;
out vec3 offset;                  // from the centre to the point on the triangle

const vec2 corners[3] = vec2[3](vec2(-1.7320509, -1.0), vec2(1.7320509, -1.0), vec2(0.0, 2.0));

void main()
{
    uvec4 particle = texelFetch(particles, gl_VertexID / 3);
    center = (view * vec4(uintBitsToFloat(particle.xyz), 1.0)).xyz;
    if (solid != 0)
        color = vec3(uvec3(particle.w, particle.w >> 8, particle.w >> 16) & 255u) / 255.0;
    else // centres of the first and last texel are the ends of the range
        color = textureLod(map, (uintBitsToFloat(particle.w) * 255.0 + 0.5) / 256.0, 0.0).rgb;

    if ((particle.x & 0x7fffffffu) > 0x7f800000u) { // not a number: hidden. GLSL need not know NaN
        offset = vec3(0.0);
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    vec2 corner = corners[gl_VertexID % 3] * radius * 1.002;
    if (parallel != 0 && center.z < 0.0) {
        offset = vec3(corner, 0.0);
        gl_Position = vec4((center.xy + corner) * scale, 0.0, 1.0);
        return;
    }
    float distance = length(center), ratio = radius / distance;
    if (!(center.z < 0.0 && ratio < 1.0) || parallel != 0) { // behind the eye, or around it, or not a number
        offset = vec3(0.0);
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    vec3 toward = center / distance;
    vec3 side = normalize(vec3(-toward.z, 0.0, toward.x)); // toward.z < 0: never zero
    vec3 above = cross(side, toward);
    corner *= sqrt(1.0 - ratio * ratio);
    offset = side * corner.x + above * corner.y - toward * (radius * ratio);
    vec3 point = center + offset;
    gl_Position = vec4(point.xy * scale, 0.0, -point.z); // depth comes from the fragment shader
}
