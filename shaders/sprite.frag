#version 330 core
// Meets the ray through this pixel with the sphere and shades the point of entry.
uniform float radius;
uniform float far;      // distance at depth 1
uniform vec3 key_light; // unit vector in camera axes
uniform vec4 material;  // base, sky, diffuse, facing: src/render/look.h
uniform float shine;
uniform float rim;
uniform int parallel;   // orthographic

flat in vec3 center;
flat in vec3 color;
in vec3 offset;
out vec4 pixel;

void main()
{
    // All differences are taken near the sphere, where floats are precise.
    vec3 point = parallel != 0 ? vec3(0.0, 0.0, -1.0) : center + offset; // along the ray
    float scale = 1.0 / dot(point, point), along = dot(offset, point) * scale;
    float half2 = (radius * radius - dot(offset, offset)) * scale + along * along;
    if (half2 < 0.0)
        discard;
    vec3 from_center = offset - (along + sqrt(half2)) * point;
    float depth = -(center.z + from_center.z);
    if (depth <= 0.0)
        discard;
    gl_FragDepth = depth / far;

    vec3 normal = from_center / radius, ray = point * sqrt(scale);
    float sky = 0.5 + 0.5 * normal.y;
    float diffuse = max(dot(normal, key_light), 0.0);
    float facing = max(-dot(normal, ray), 0.0);
    float light = (material.x + material.y * sky + material.z * diffuse) *
                  (1.0 - material.w + material.w * facing);
    float glance = max(dot(reflect(ray, normal), key_light), 0.0);
    glance *= glance;
    glance *= glance;
    glance *= glance; // to the power of 8, and below of 24
    if (facing * facing < rim) {
        light = min(light, 1.0) * 0.25;
        glance = 0.0;
    }
    pixel = vec4(min(color * min(light, 1.0) + shine * glance * glance * glance, vec3(1.0)), 1.0);
}
