/** Shaders of a drape. All colours are sRGB as input and output, and linear in between. */

/**
 * The lights follow the camera, as in a studio with a turning garment: each side is lit the same. A
 * key light, of which a share arrives by nine looks at what it sees; a weak fill from the other
 * side, light from above, and a rim from behind. The sum is never more than 0.905: white fabric is
 * #f4f4f2 at most, and nothing is clipped. Comments are outside, since they would be sent.
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

float reached(vec3 n) {
  vec4 seen = shadowMatrix * vec4(place + 0.6 * n, 1.0);
  vec3 at = seen.xyz / seen.w;
  float sum = 0.0;
  for (int i = -1; i <= 1; i++)
    for (int j = -1; j <= 1; j++) {
      vec2 near = at.xy + vec2(i, j) * (2.2 / 1024.0);
      sum += step(at.z - 0.0015, texture2D(shadows, near).r);
    }
  return sum / 9.0;
}

vec3 lit(vec3 albedo, vec3 n, float open, float sheen) {
  vec3 towards = normalize(cameraPosition - place);
  vec3 left = normalize(cross(vec3(0.0, 1.0, 0.0), towards));
  float above = mix(0.31, 0.52, 0.5 + 0.5 * n.y);
  float straight = max(0.0, 0.85 * dot(n, key) + 0.15) * mix(0.25, 1.0, reached(n));
  float weak = max(0.0, dot(n, normalize(0.75 * left + 0.6 * towards)));
  float away = 1.0 - abs(dot(n, towards));
  float rim = away * away * away * max(0.0, 0.5 + 0.5 * n.y);
  float light = open * (above + 0.1 * weak) + 0.57 * straight + (0.12 + sheen) * rim;
  return albedo * min(vec3(0.905, 0.905, 0.885), vec3(light));
}
`;

const standing = `
  place = position;
  facing = normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
`;

/**
 * The fabric, and its thickness along open edges, whose vertices have a side. The print is pale on
 * the inside. Threads show as long as there are pixels for them; those of a knit are a V on each
 * side of a wale. A row of stitches runs along each hem, which is thicker than the rest. Heights
 * tilt the normal as in Mikkelsen 2010, Bump mapping unparametrized surfaces on the GPU.
 */
export const cloth = {
  vertex: `
varying vec3 place;
varying vec3 facing;
attribute float printed;
attribute float piece;
attribute vec2 shape;
attribute vec2 drafted;
attribute vec2 hem;
attribute float hollow;
attribute float side;
uniform bool isDrafted;
uniform float chosen;
uniform float pointed;
uniform float thickness;
varying vec2 at;
varying vec2 yarn;
varying vec2 seam;
varying float deep;
varying float edge;
varying float isPrinted;
varying float mark;
void main() {
  at = isDrafted ? drafted : uv;
  yarn = shape;
  seam = hem;
  deep = hollow;
  edge = abs(side);
  isPrinted = printed;
  mark = abs(piece - chosen) < 0.5 ? 0.07 : (abs(piece - pointed) < 0.5 ? 0.06 : 0.0);
  place = position + 0.5 * thickness * side * normal;
  facing = normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 1.0);
}`,
  fragment: `
${lighting}
uniform sampler2D tile;
uniform vec3 bare;
uniform vec3 accent;
uniform float weave;
uniform float pitch;
uniform float relief;
uniform float sheen;
uniform float opacity;
uniform float stitch;
uniform float thickness;
varying vec2 at;
varying vec2 yarn;
varying vec2 seam;
varying float deep;
varying float edge;
varying float isPrinted;
varying float mark;
const float turn = 6.2832;
const float hemWidth = 1.5;

float threads(vec2 p) {
  vec2 w = turn * p / pitch;
  if (weave < 0.5) return 0.5 + 0.5 * sin(0.5 * w.x) * sin(0.5 * w.y);
  if (weave < 1.5) return 0.5 + 0.5 * sin(0.7071 * (w.x + w.y)) * (0.8 + 0.2 * sin(2.0 * w.x));
  return 0.5 + 0.5 * sin(w.x) * (0.7 + 0.3 * sin(w.y + 2.0 * abs(sin(0.5 * w.x))));
}

void main() {
  vec3 n = normalize(facing) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 right = dFdx(place);
  vec3 up = dFdy(place);
  if (edge > 0.5) {
    n = normalize(cross(right, up));
    n *= sign(dot(n, cameraPosition - place));
  }
  vec3 ink = isPrinted > 0.5 ? texture2D(tile, at).rgb : linear(bare);
  if (!gl_FrontFacing && edge < 0.5) ink = mix(ink, vec3(1.0), 0.7) * 0.86;
  vec2 pixel = fwidth(yarn) / pitch;
  float near = clamp(1.5 - 3.5 * max(pixel.x, pixel.y), 0.0, 1.0);
  float thread = threads(yarn);
  ink *= 1.0 - 0.1 * near * (1.0 - thread);
  float wide = fwidth(seam.x);
  float row = 1.0 - smoothstep(0.03, 0.06 + wide, abs(seam.x - hemWidth));
  float dashes = mix(0.7, step(0.3, fract(seam.y / 0.35)), clamp(1.4 - 6.0 * wide, 0.0, 1.0));
  ink *= 1.0 - stitch * row * dashes * min(1.0, 0.25 + 0.05 / max(wide, 1e-4));
  float height = relief * near * thread;
  height += thickness * (1.0 - smoothstep(hemWidth - 0.25, hemWidth, seam.x));
  height -= 0.5 * thickness * (1.0 - smoothstep(0.0, 0.2 + wide, abs(seam.x - hemWidth)));
  vec3 r1 = cross(up, n);
  vec3 r2 = cross(n, right);
  float det = dot(right, r1);
  vec3 slope = sign(det) * (dFdx(height) * r1 + dFdy(height) * r2);
  if (edge < 0.5) n = normalize(abs(det) * n - slope);
  float side = gl_FrontFacing ? 1.0 : -1.0;
  float open = 1.0 - clamp(1.6 * side * deep, -0.12, 0.4);
  vec3 colour = lit(ink, n, open, sheen);
  float across = max(0.2, abs(dot(normalize(facing), normalize(cameraPosition - place))));
  float cover = 1.0 - pow(1.0 - opacity, 1.0 / across);
  gl_FragColor = vec4(mix(encoded(colour), accent, mark), opacity < 1.0 ? cover : 1.0);
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
  gl_FragColor = vec4(encoded(lit(linear(own), normalize(facing), 1.0, 0.0)), 1.0);
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
