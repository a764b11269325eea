// `npm run icons`: draws public/icon.svg as the PNG icons of an installed page.
import {readFileSync, writeFileSync} from 'node:fs';

import {createCanvas, loadImage} from '@napi-rs/canvas';

import {root} from './shell.mjs';

const svg = readFileSync(`${root}/public/icon.svg`, 'utf8');
/** The system crops it to any shape, so the ground reaches the edges. */
const whole = svg.replace(/ rx="[\d.]+"/, '');

for (const [name, side, picture] of [
  ['icon-180', 180, whole],
  ['icon-192', 192, svg],
  ['icon-512', 512, svg],
  ['icon-whole-512', 512, whole],
]) {
  const sized = picture.replace('<svg ', `<svg width="${side}" height="${side}" `);
  const canvas = createCanvas(side, side);
  canvas.getContext('2d').drawImage(await loadImage(Buffer.from(sized)), 0, 0, side, side);
  writeFileSync(`${root}/public/${name}.png`, canvas.toBuffer('image/png'));
}
