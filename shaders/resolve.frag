// The mean of a pixel's samples, over the background of its row. src/render/resolve.c puts #version before
// it, and as constants SAMPLES of a pixel in x and in y; DEEP: they have 16 bits, not 8; OVER: they were drawn
// over nothing.
uniform sampler2D drawn;      // samples, rows from the bottom
uniform sampler2D background; // a texel for each row of pixels, from the top; alpha 0: there is none

out uvec4 pixel;              // bytes, rows from the top

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    ivec2 first = ivec2(place.x, textureSize(background, 0).y - 1 - place.y) * SAMPLES;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < SAMPLES; y++)
        for (int x = 0; x < SAMPLES; x++) {
            vec4 value = texelFetch(drawn, first + ivec2(x, y), 0);
            sum += DEEP ? floor(value * 255.0 + 0.5) : value;
        }
    if (!DEEP)
        sum = floor(sum * 255.0 + 0.5); // exactly the sum of bytes
    const float count = float(SAMPLES * SAMPLES);
    vec3 mean = sum.rgb / count;
    if (!OVER) {
        pixel = uvec4(mean + 0.5, 255u);
        return;
    }
    vec4 back = texelFetch(background, ivec2(0, place.y), 0);
    float empty = 1.0 - sum.a / (255.0 * count), alpha = 1.0 - empty * (1.0 - back.a);
    float whole = alpha > 1e-4 ? alpha : 1.0;
    mean = (mean + 255.0 * empty * back.rgb * back.a) / whole;
    pixel = uvec4(vec4(mean, 255.0 * alpha) + 0.5);
}
