/** A small part of a print, drawn with its real lattice. */
import {html, svg, type TemplateResult} from 'lit';

import {noPicture} from '../../model/design/design.js';
import {norm} from '../../model/geometry/vectors.js';
import type {Print} from '../../model/print/repeating-print.js';
import {imageCell} from '../../model/print/wallpaper.js';

const bareFabric = '#f1ede3';
const hasPicture = (image: string): boolean => image !== '' && image !== noPicture;

/** Usual extent of a swatch: it shows this number of repeats by the longer of w1 and w2. */
const usualRepeats = 2.4;

/** @param id unique among the swatches of one element */
export function swatch(
  id: string,
  print: Print,
  image = print.image ?? '',
  repeats = usualRepeats,
): TemplateResult {
  const [a, b] = imageCell(print);
  const [width, height] = [norm(a), norm(b)];
  const side = repeats * Math.max(norm(print.w1), norm(print.w2));
  // y points down in the image, against the second edge of the cell
  const matrix = [a[0] / width, -a[1] / width, -b[0] / height, b[1] / height, side / 2, side / 2];
  return html`<svg
    viewBox="0 0 ${side} ${side}"
    preserveAspectRatio="xMidYMid slice"
    aria-hidden="true"
  >
    ${
      hasPicture(image)
        ? svg`<pattern
        id=${id}
        patternUnits="userSpaceOnUse"
        width=${width}
        height=${height}
        patternTransform="matrix(${matrix.join(' ')})"
      >
        <image href=${image} width=${width} height=${height} preserveAspectRatio="none"></image>
      </pattern>
      <rect width="100%" height="100%" fill="url(#${id})"></rect>`
        : svg`<rect width="100%" height="100%" fill=${bareFabric}></rect>`
    }
  </svg>`;
}
