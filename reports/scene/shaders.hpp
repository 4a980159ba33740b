// The programs that run per vertex and per pixel, GLSL 3.30. Colours are linear light inside them. Between them samples hold the square
// root of the light: as even to the eye as sRGB in eight bits, and far cheaper where every pixel has four samples to write. The last one
// writes sRGB.
#pragma once

namespace pmreport::scene::shaders {

// Positions come in pixels of the picture. They are snapped to the rasteriser's own grid of 1/256 pixel before the division by the
// picture's size, so that a tile of any size and place sees the same triangles.
//
// `outline` [px] moves a vertex outwards in the picture: the back faces of a solid so grown stand out around it as its outline.
inline constexpr const char* solid_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
uniform vec2 size;        // of the supersampled picture
uniform vec2 depth;       // far end, 1 / range
uniform float supersample, outline;
uniform mat4 to_light;    // picture -> place in the shadow map, height above ground
out vec3 n, light;
out vec4 paint;
void main() {
  n = normal;
  paint = color;
  light = (to_light * vec4(position, 1.0)).xyz;
  vec2 out2 = vec2(normal.x, -normal.y);
  float reach = length(out2);
  vec2 p = position.xy + (reach > 1e-3 ? outline * out2 / reach : vec2(0.0));
  vec2 snapped = floor(p * supersample * 256.0 + 0.5) / 256.0;
  gl_Position = vec4(2.0 * snapped / size - 1.0, 1.0 - 2.0 * (position.z - depth.x) * depth.y, 1.0);
}
)";

// Light from three sides and from the whole sky. The shine is a product of squares: pow() differs between processors.
//
// The shadow map holds the greatest height above each place, seen along the light; what lies lower is in its shade. Five looks around the
// place soften the edge. Whole texels are fetched, here and below: filtered looks take several times as long, above all to compile.
inline constexpr const char* solid_fragment = R"(#version 330 core
in vec3 n, light;
in vec4 paint;
uniform vec3 up;          // of the world, in axes of the view
uniform float shade_bias, shade_reach, map_size;
uniform sampler2D heights;
out vec4 result;

float lit(vec2 offset) {
  vec2 at = clamp(map_size * light.xy + shade_reach * offset, vec2(0.0), vec2(map_size - 1.0));
  return texelFetch(heights, ivec2(at), 0).r > light.z + shade_bias ? 0.0 : 1.0;
}

void main() {
  vec3 base = paint.rgb * (paint.rgb * (paint.rgb * 0.305306011 + 0.682171111) + 0.012522878);  // sRGB to linear
  vec3 m = normalize(n);
  float rise = dot(m, up);
  float key = max(0.0, dot(m, vec3(-0.485, 0.566, 0.667)));
  float fill = max(0.0, dot(m, vec3(0.640, 0.105, 0.761)));
  float back = max(0.0, dot(m, vec3(0.30, 0.80, -0.52)));
  float sky = 0.5 + 0.5 * rise;
  float seen = 0.28 * lit(vec2(0.0)) +
               0.18 * (lit(vec2(0.92, 0.38)) + lit(vec2(-0.38, 0.92)) + lit(vec2(-0.92, -0.38)) + lit(vec2(0.38, -0.92)));
  float open = mix(1.0, seen, 0.55 * smoothstep(0.05, 0.5, rise));
  float h = max(0.0, dot(m, vec3(-0.266, 0.310, 0.913)));  // between key light and viewer
  float s = h * h; s *= s; s *= s; s *= s; s *= s;  // h^32
  vec3 sum = base * (open * (0.62 * key + mix(0.10, 0.34, sky)) + 0.22 * fill + 0.12 * back) + 0.16 * s * open;
  result = vec4(sqrt(min(sum, vec3(1.0))), paint.a);
}
)";

// A surface looks alike from both sides. Where it is seen aslant it is thicker to the eye and hides more, so that its rim tells its shape.
inline constexpr const char* surface_fragment = R"(#version 330 core
in vec3 n;
in vec4 paint;
uniform vec3 up;
out vec4 result;
void main() {
  vec3 base = paint.rgb * (paint.rgb * (paint.rgb * 0.305306011 + 0.682171111) + 0.012522878);
  vec3 m = length(n) > 0.0 ? normalize(n) : vec3(0.0, 0.0, 1.0);
  if (m.z < 0.0) m = -m;
  float key = max(0.0, dot(m, vec3(-0.485, 0.566, 0.667)));
  float fill = max(0.0, dot(m, vec3(0.640, 0.105, 0.761)));
  float sky = 0.5 + 0.5 * dot(m, up);
  float h = max(0.0, dot(m, vec3(-0.266, 0.310, 0.913)));
  float s = h * h; s *= s; s *= s; s *= s; s *= s;
  vec3 sum = base * (0.62 * key + mix(0.16, 0.36, sky) + 0.26 * fill) + 0.08 * s;
  float aslant = 1.0 - m.z;
  result = vec4(sqrt(min(sum, vec3(1.0))), mix(paint.a, 1.0, 0.6 * aslant * aslant * aslant));
}
)";

// Lines, outlines, and what is seen through others: paint alone.
inline constexpr const char* plain_fragment = R"(#version 330 core
in vec4 paint;
uniform float opacity;
uniform vec4 ink;         // replaces the paint as far as its alpha says
out vec4 result;
void main() {
  vec3 base = paint.rgb * (paint.rgb * (paint.rgb * 0.305306011 + 0.682171111) + 0.012522878);
  result = vec4(sqrt(max(mix(base, ink.rgb, ink.a), vec3(0.0))), opacity);
}
)";

inline constexpr const char* cast_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 to_light;
uniform float top;        // greatest height
void main() {
  vec3 l = (to_light * vec4(position, 1.0)).xyz;
  gl_Position = vec4(2.0 * l.xy - 1.0, 1.0 - 2.0 * clamp(l.z / top, 0.0, 1.0), 1.0);
}
)";
inline constexpr const char* cast_fragment = R"(#version 330 core
uniform float top;
out float height;
void main() { height = top * (1.0 - gl_FragCoord.z); }
)";

// One triangle that covers the picture.
inline constexpr const char* whole_vertex = R"(#version 330 core
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
)";

// Binomial weights of 13 looks, about a Gaussian of 1.7 steps. The first pass asks whether anything stands there at all.
inline constexpr const char* blur_fragment = R"(#version 330 core
uniform sampler2D source;
uniform int size, scale;  // of the result; of the source to the result
uniform ivec2 stride;
uniform float above;      // more than this counts as 1, if not negative
out float shade;
void main() {
  const float weight[7] = float[7](924.0, 792.0, 495.0, 220.0, 66.0, 12.0, 1.0);
  float sum = 0.0;
  for (int k = -6; k <= 6; ++k) {
    ivec2 at = clamp(ivec2(gl_FragCoord.xy) + k * stride, ivec2(0), ivec2(size - 1));
    float x = texelFetch(source, scale * at, 0).r;
    sum += weight[abs(k)] * (above < 0.0 ? x : (x > above ? 1.0 : 0.0));
  }
  shade = sum / 4096.0;
}
)";

// All samples of a pixel are averaged in linear light, and laid over the ground. The ground is the same for all samples to within what an
// eye can tell and knows its own edges analytically, so it is evaluated once per pixel, here.
inline constexpr const char* develop_fragment = R"(#version 330 core
uniform sampler2DMS samples;
uniform int supersample, any;   // any 0: nothing but ground in this tile
uniform int films;              // 1: there are translucent surfaces or ghosts
uniform vec2 origin;            // of the tile [px]
uniform vec4 background;        // premultiplied
uniform int ground;             // 0 none, 1 plane, 2 seen edge-on as a line
uniform vec2 place, place_x, place_y;    // of pixel (0, 0) on the ground [m], and per pixel
uniform vec2 middle;
uniform float fade_radius, grid, horizon;
uniform vec4 to_shade;          // ground [m] -> shadow map: factor, offset
uniform sampler2D shade;
out vec4 result;

vec4 over(vec4 a, vec4 b) { return a + (1.0 - a.a) * b; }
float line(float cells, float spacing, float width) {
  float away = abs(fract(cells - 0.5) - 0.5) * spacing;
  return clamp(0.5 * width + 0.5 - away, 0.0, 1.0) * min(width, 1.0) * smoothstep(4.0, 14.0, spacing);
}

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * supersample;
  vec4 solids = vec4(0.0);
  if (any == 1) {
    for (int y = 0; y < supersample; ++y)
      for (int x = 0; x < supersample; ++x)
        for (int k = 0; k < 4; ++k) {
          vec4 root = texelFetch(samples, first + ivec2(x, y), k);
          solids += vec4(root.rgb * root.rgb / max(root.a, 1e-3), root.a);  // roots are premultiplied, light is to be
        }
    solids /= float(4 * supersample * supersample);
  }
  vec4 below = background;
  vec2 px = gl_FragCoord.xy + origin;
  if (ground == 1 && solids.a < 0.9999) {
    vec2 g = place + px.x * place_x + px.y * place_y;
    float fade = 1.0 - smoothstep(0.45, 1.0, length(g - middle) / fade_radius);
    vec2 spacing = grid / vec2(length(vec2(place_x.x, place_y.x)), length(vec2(place_x.y, place_y.y)));
    vec2 cells = g / grid;
    float fine = max(line(cells.x, spacing.x, 0.9), line(cells.y, spacing.y, 0.9));
    float coarse = max(line(cells.x / 5.0, 5.0 * spacing.x, 1.2), line(cells.y / 5.0, 5.0 * spacing.y, 1.2));
    float ink = fade * max(0.06, max(0.45 * fine, 0.70 * coarse));
    below = over(ink * vec4(0.13, 0.17, 0.23, 1.0), below);
    float dark = 0.40 * texture(shade, g * to_shade.xy + to_shade.zw).r;
    below = over(dark * vec4(0.02, 0.03, 0.05, 1.0), below);
  } else if (ground == 2) {
    float fade = 1.0 - smoothstep(0.55, 1.0, abs(px.x - middle.x) / fade_radius);
    below = over(0.6 * fade * clamp(1.1 - abs(px.y - horizon), 0.0, 1.0) * vec4(0.13, 0.17, 0.23, 1.0), below);
  }
  vec4 sum = over(solids, below);
  // Over solids translucent surfaces are mixed by roots of light, and so they are to be over opaque ground: with root light r, premultiplied
  // by the opacity a, and w that of the ground, that is darker than the mixture of lights by (1 - a) / a (r - a w)^2.
  if (films == 1 && any == 1 && background.a == 1.0) {
    vec3 w = sqrt(max(below.rgb, vec3(0.0))), darker = vec3(0.0);
    for (int y = 0; y < supersample; ++y)
      for (int x = 0; x < supersample; ++x)
        for (int k = 0; k < 4; ++k) {
          vec4 root = texelFetch(samples, first + ivec2(x, y), k);
          if (root.a < 0.002) continue;
          vec3 d = root.rgb - root.a * w;
          darker += (1.0 - root.a) / root.a * d * d;
        }
    sum.rgb = max(sum.rgb - darker / float(4 * supersample * supersample), vec3(0.0));
  }
  result = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a) : vec4(0.0);
}
)";

}  // namespace pmreport::scene::shaders
