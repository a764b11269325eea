// Draws docs/before-after.svg: one dress with its print as drafted, and as aligned.
import {writeFileSync} from 'node:fs';

import {root} from '../shell.mjs';
import {drapePicture, resultOf, sharp, showDrape} from './samples.mjs';

/** Parts of the view of the drape, in its heights: the dress, and a seam to enlarge. */
const dress = [-0.205, 0.095, 0.41, 0.75];
const seam = [-0.124, 0.575, 0.12, 0.12];

/** Width of one half, and height of the picture. [px] */
const [half, height] = [600, 760];
/** Place of the dress in a half, and the circle with the enlarged seam, at the height of the seam. [px] */
const at = {x: 24, y: 112, width: 345};
const lens = {x: 470, radius: 116};

export async function beforeAfter(open) {
  const page = await open({garment: 'princess-dress', print: 'pmm', size: [1300, 1000], ratio: 3});
  const {drafted, final} = (await resultOf(page)).metrics.localCm;
  await showDrape(page);
  const after = await pictures(page);
  await page.locator('.application:visible').focus();
  await page.keyboard.down('w'); // shows the dress as drafted
  await sharp(page);
  const before = await pictures(page);
  await page.close();
  const content = [
    panel(0, 'Cut on grain, print ignored', misses(drafted), before),
    panel(half, 'Cut with Seamwise', misses(final), after),
  ];
  writeFileSync(`${root}/docs/before-after.svg`, drawing(content.join('\n')));
}

async function pictures(page) {
  return {
    dress: await drapePicture(page, dress, Math.round(1.5 * at.width), 0.45),
    seam: await drapePicture(page, seam, 2.5 * lens.radius, 0.6),
  };
}

const misses = (cm) => `The print misses by ${(10 * cm).toFixed(1)} mm at the seams, on average`;

const drawing = (content) => `<svg xmlns="http://www.w3.org/2000/svg" \
viewBox="0 0 ${2 * half} ${height}" font-family="system-ui, 'Segoe UI', Roboto, sans-serif">
<rect width="${2 * half}" height="${height}" fill="#f4f3f0"/>
<path d="M${half} 40V${height - 40}" stroke="#c9c6bf"/>
${content}
</svg>
`;

const image = (webp, place) =>
  `<image href="data:image/webp;base64,${webp.toString('base64')}" ${place}/>`;

function panel(left, title, text, {dress: whole, seam: enlarged}) {
  const scale = at.width / dress[2];
  const middle = seam.slice(0, 2).map((edge, k) => edge + seam[2 + k] / 2 - dress[k]);
  const [x, y] = [at.x + scale * middle[0], at.y + scale * middle[1]];
  const small = (scale * seam[2]) / 2;
  const clip = `lens-${left}`;
  const box = `x="${lens.x - lens.radius}" y="${y - lens.radius}" width="${2 * lens.radius}"`;
  const rim = 'fill="none" stroke="#26282c" stroke-width="2"';
  return `<g transform="translate(${left} 0)">
<text x="32" y="52" font-size="28" font-weight="600" fill="#26282c">${title}</text>
<text x="32" y="82" font-size="18" fill="#5f6268">${text}</text>
${image(whole, `x="${at.x}" y="${at.y}" width="${at.width}"`)}
<path d="M${x + small} ${y}H${lens.x - lens.radius}" ${rim}/>
<circle cx="${x}" cy="${y}" r="${small}" ${rim}/>
<clipPath id="${clip}"><circle cx="${lens.x}" cy="${y}" r="${lens.radius}"/></clipPath>
${image(enlarged, `${box} clip-path="url(#${clip})"`)}
<circle cx="${lens.x}" cy="${y}" r="${lens.radius}" ${rim}/>
</g>`;
}
