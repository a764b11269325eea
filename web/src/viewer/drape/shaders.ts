/** Shaders of a drape. All colours are sRGB as input and output, and linear in between. */

/**
 * The lights follow the camera, as in a studio with a turning garment: each side is lit the same.
 */
const lighting = `
uniform vec3 key;
uniform mat4 shadowMatrix;
uniform sampler2D shadows;
varying vec3 place;
varying vec3 facing;

vec3 linear(vec3 c) {
  return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}
vec3 encoded(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

/** The share of the key light that arrives: nine looks at what it sees. */
float reached(vec3 n) {
  vec4 seen = shadowMatrix * vec4(place + 0.6 * n, 1.0);
  vec3 at = seen.xyz / seen.w;
  float sum = 0.0;
  for (int i = -1; i <= 1; i++)
    for (int j = -1; j <= 1; j++) {
      vec2 near = at.xy + vec2(i, j) * (1.6 / 1024.0);
      sum += step(at.z - 0.0015, texture2D(shadows, near).r);
    }
  return sum / 9.0;
}

/** Never more than 0.905: white cloth is #f4f4f2 at most, and nothing is clipped. */
vec3 lit(vec3 albedo, vec3 n) {
  float above = mix(0.46, 0.62, 0.5 + 0.5 * n.y);
  float straight = max(0.0, 0.82 * dot(n, key) + 0.18) * mix(0.35, 1.0, reached(n));
  return albedo * min(vec3(0.905, 0.905, 0.885), vec3(above) + 0.36 * straight);
}
`;

const standing = `
  place = position;
  facing = normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
`;

export const cloth = {
  vertex: `
varying vec3 place;
varying vec3 facing;
attribute float printed;
attribute float piece;
attribute vec2 shape;
attribute vec2 drafted;
uniform bool isDrafted;
uniform float chosen;
uniform float pointed;
varying vec2 at;
varying vec2 yarn;
varying float isPrinted;
varying float mark;
void main() {
  at = isDrafted ? drafted : uv;
  yarn = shape;
  isPrinted = printed;
  mark = abs(piece - chosen) < 0.5 ? 0.07 : (abs(piece - pointed) < 0.5 ? 0.06 : 0.0);
  ${standing}
}`,
  fragment: `
${lighting}
uniform sampler2D tile;
uniform vec3 bare;
uniform vec3 accent;
varying vec2 at;
varying vec2 yarn;
varying float isPrinted;
varying float mark;
void main() {
  vec3 n = normalize(facing) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 ink = isPrinted > 0.5 ? texture2D(tile, at).rgb : linear(bare);
  // a print is pale on the inside of its cloth
  if (!gl_FrontFacing) ink = mix(ink, vec3(1.0), 0.7) * 0.86;
  // threads of 0.8 mm, as long as there are pixels to show them
  vec2 thread = yarn * 78.5;
  vec2 step = fwidth(thread);
  float near = clamp(1.5 - 0.7 * max(step.x, step.y), 0.0, 1.0);
  ink *= 1.0 - 0.06 * near * (0.5 + 0.5 * sin(thread.x) * sin(thread.y));
  vec3 colour = lit(ink, n);
  gl_FragColor = vec4(mix(encoded(colour), accent, mark), 1.0);
}`,
};

export const dummy = {
  vertex: `
varying vec3 place;
varying vec3 facing;
attribute vec3 colour;
varying vec3 own;
void main() {
  own = colour;
  ${standing}
}`,
  fragment: `
${lighting}
varying vec3 own;
void main() {
  gl_FragColor = vec4(encoded(lit(linear(own), normalize(facing))), 1.0);
}`,
};

/** Depth as seen from the key light. */
export const depth = {
  vertex: `
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,
  fragment: `
void main() {
  gl_FragColor = vec4(1.0);
}`,
};

/** A ribbon along a line of the mesh: at least 1.2 mm wide, lifted by 0.5 mm. */
export const ribbon = {
  vertex: `
attribute vec3 across;
attribute float side;
attribute float along;
attribute float width;
attribute vec2 dash;
attribute vec3 ink;
uniform float perPixel;
varying float run;
varying vec2 rhythm;
varying vec3 own;
void main() {
  run = along;
  rhythm = dash;
  own = ink;
  vec4 middle = modelViewMatrix * vec4(position, 1.0);
  float reach = max(0.06, 0.5 * width * perPixel * -middle.z);
  gl_Position = projectionMatrix * modelViewMatrix
    * vec4(position + 0.05 * normal + side * reach * across, 1.0);
  gl_Position.z -= 0.0004 * gl_Position.w;
}`,
  fragment: `
varying float run;
varying vec2 rhythm;
varying vec3 own;
void main() {
  if (rhythm.y > 0.0 && mod(run, rhythm.x + rhythm.y) > rhythm.x) discard;
  gl_FragColor = vec4(own, 1.0);
}`,
};

/** Shadows on the floor: narrow and dark from the foot, soft and wide from the garment. */
export const floor = {
  vertex: `
varying vec2 from;
void main() {
  from = position.xz;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,
  fragment: `
uniform vec2 soft;
uniform float foot;
uniform float middle;
uniform float strength;
varying vec2 from;
void main() {
  vec2 at = vec2(from.x, from.y - middle);
  float wide = exp(-2.2 * dot(at / soft, at / soft));
  float close = exp(-1.6 * max(0.0, length(at) - foot));
  gl_FragColor = vec4(0.0, 0.0, 0.0, strength * (0.16 * wide + 0.3 * close));
}`,
};

/** Copies the finished picture to the current render target. */
export const copy = {
  vertex: `
uniform vec2 part;
varying vec2 at;
void main() {
  at = (0.5 + 0.5 * position.xy) * part;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`,
  fragment: `
uniform sampler2D picture;
varying vec2 at;
void main() {
  gl_FragColor = texture2D(picture, at);
}`,
};
