/** Patterns as SVG in the styles of different programs. */

/**
 * `d` of a bodice half with a curved armhole and neck, `u` units a millimetre: 240 by 400 mm, its
 * fold at x = 0.
 */
export const bodice = (u = 1, [x, y]: readonly [number, number] = [0, 0]): string => {
  const at = (px: number, py: number): string => `${u * (x + px)},${u * (y + py)}`;
  return [
    `M ${at(0, 60)} L ${at(0, 400)} L ${at(240, 400)} L ${at(240, 200)}`,
    `C ${at(200, 200)} ${at(180, 150)} ${at(190, 20)} L ${at(70, 0)}`,
    `C ${at(70, 40)} ${at(40, 60)} ${at(0, 60)} z`,
  ].join(' ');
};

/** The area of the bodice, by an independent integral. [cm2] */
export function bodiceArea(): number {
  const curves = [
    ...[
      [0, 60, 0, 400],
      [0, 400, 240, 400],
      [240, 400, 240, 200],
      [190, 20, 70, 0],
    ].map(([x = 0, y = 0, p = 0, q = 0]) => [x, y, x, y, p, q, p, q]),
    [240, 200, 200, 200, 180, 150, 190, 20],
    [70, 0, 70, 40, 40, 60, 0, 60],
  ];
  const steps = 2000;
  let doubled = 0;
  for (const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0] of curves) {
    const on = (t: number): readonly [number, number] => {
      const w = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3];
      const sum = (...v: readonly number[]): number =>
        v.reduce((all, one, k) => all + one * (w[k] ?? 0), 0);
      return [sum(a, c, e, g), sum(b, d, f, h)];
    };
    for (let k = 0; k < steps; k++) {
      const [p, q] = [on(k / steps), on((k + 1) / steps)];
      doubled += p[0] * q[1] - p[1] * q[0];
    }
  }
  return Math.abs(doubled) / 200;
}

export const svg = (attributes: string, ...content: readonly string[]): string =>
  [`<svg xmlns="http://www.w3.org/2000/svg" ${attributes}>`, ...content, '</svg>'].join('\n');

/** Attributes of a sheet of 60 by 50 cm, a unit a millimetre. */
export const millimetreSheet = 'width="600mm" height="500mm" viewBox="0 0 600 500"';

/** A line in the style of programs without fills. */
export const stroked = (d: string, more = ''): string =>
  `<path d="${d}" fill="none" stroke="black" ${more}/>`;

export const words = (x: number, y: number, text: string, size = 10): string =>
  `<text x="${x}" y="${y}" font-size="${size}">${text}</text>`;

/**
 * One part in FreeSewing's style: on the fold, with allowance along all other edges, a notch, a
 * button and a dart.
 */
export const freesewingPart = (name: string, scale = 1): string => {
  const u = scale;
  const dart = `M ${100 * u},250 L ${110 * u},300 L ${100 * u},350 L ${90 * u},300 z`;
  return `<g id="fs-stack-x.${name}" transform="translate(20, 10)"><g id="fs-stack-x.${name}-part-x.${name}" transform="translate(5, 5)">
<path class="fabric" id="fs-1" d="${bodice(u)}" />
<path class="fabric sa" id="fs-2" d="M 0,${410 * u} L ${250 * u},${410 * u} L ${250 * u},${190 * u} L ${200 * u},${10 * u} L ${70 * u},${-10 * u} L ${60 * u},0 L 0,${50 * u}M 0,${400 * u} L 0,${410 * u}" />
<path class="note" marker-start="url(#cutonfoldFrom)" marker-end="url(#cutonfoldTo)" id="fs-3" d="M 0,${100 * u} L 15,${100 * u} L 15,${380 * u} L 0,${380 * u}" />
<path class="fabric" id="fs-4" d="${dart}" />
<path class="hidden" id="fs-6" d="M 0,${200 * u} L ${240 * u},${200 * u}" />
<text><textPath xlink:href="#fs-6" startOffset="50%"><tspan dy="-1">x:chestLine &#160;&#160; x:chestLine &#160;&#160; x:chestLine</tspan></textPath></text>
<path class="hidden" id="fs-5" d="M 0,0 L 5000,5000 L 0,5000 z" />
<text class="text-lg fill-current font-bold left" transform="matrix(1, 0, 0, 1, 0, 0) rotate(0 100 100)" x="100" y="100"><tspan>${name} </tspan></text>
<text class="text-md" x="100" y="120"><tspan>plugin-annotations:cut,1,plugin-annotations:onFold,plugin-annotations:from,plugin-annotations:fabric,</tspan><tspan x="100" dy="8"> </tspan></text>
<use x="${240 * u}" y="${300 * u}" xlink:href="#notch" transform="translate(240, 300) scale(1) translate(-240, -300)"></use>
<use x="50" y="200" xlink:href="#button" transform="translate(50, 200) scale(1) translate(-50, -200)"></use>
</g></g>`;
};

export const freesewing = (...parts: readonly string[]): string =>
  `<?xml version="1.0" encoding="UTF-8" standalone="no"?><svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" freesewing="4.10.2" class="freesewing" width="600mm" height="500mm" viewBox="0 0 600 500">
<style type="text/css"> <![CDATA[ svg.freesewing path { fill: none; stroke: none } ]]> </style>
<defs> notch="
<g id="notch"><circle cy="0" cx="0" r="1.4"></circle></g>" button="<g id="button"><circle cx="0" cy="0" r="3.4"></circle></g>"
</defs>
<g id="fs-container">
${parts.join('\n')}
</g></svg>`;
