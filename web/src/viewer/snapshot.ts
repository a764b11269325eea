/** The whole sheet as a picture to keep. */
import {
  Color,
  LinearSRGBColorSpace,
  type OrthographicCamera,
  type Scene,
  type WebGLRenderer,
} from 'three';

import {readBack} from './read-back.js';
import {labelLines, labelSize, type PatternScene} from './scene.js';
import {toScreen, type SheetView} from './sheet-view.js';
import {inks, type Appearance} from './strokes.js';

const leading = 1.25;

export interface Shot {
  readonly width: number;
  readonly height: number;
  readonly view: SheetView;
  /** Pixels of the picture per CSS px of the view. */
  readonly ratio: number;
}

/** Draws into a target of its own, and the names over that. @throws {Error} where the browser makes no picture */
export async function snapshot(
  renderer: WebGLRenderer,
  [object, camera]: readonly [Scene, OrthographicCamera],
  scene: PatternScene,
  shot: Shot,
  appearance: Appearance,
): Promise<Blob> {
  const {width, height} = shot;
  const pixels = await drawn(renderer, [object, camera], shot, appearance);
  if (!pixels) throw new Error('The browser has taken the graphics context away.');
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d');
  if (!context) throw new Error('The picture cannot be drawn.');
  context.putImageData(pixels, 0, 0);
  drawNames(context, scene, shot, appearance);
  const blob = await new Promise<Blob | null>((resolve) => {
    canvas.toBlob(resolve, 'image/png');
  });
  if (!blob) throw new Error('The picture cannot be written.');
  return blob;
}

function drawn(
  renderer: WebGLRenderer,
  [object, camera]: readonly [Scene, OrthographicCamera],
  shot: Shot,
  appearance: Appearance,
): Promise<ImageData | undefined> {
  return readBack(renderer, shot, () => {
    const [r, g, b] = inks[appearance].paper;
    const [colour, alpha] = [renderer.getClearColor(new Color()), renderer.getClearAlpha()];
    renderer.setClearColor(new Color().setRGB(r / 255, g / 255, b / 255, LinearSRGBColorSpace), 1);
    renderer.clear();
    renderer.setClearColor(colour, alpha);
    renderer.render(object, camera);
  });
}

function drawNames(
  context: CanvasRenderingContext2D,
  {pieces}: PatternScene,
  {width, height, view, ratio}: Shot,
  appearance: Appearance,
): void {
  const size = {width: width / ratio, height: height / ratio};
  context.scale(ratio, ratio);
  context.font = `500 ${labelSize}px system-ui, sans-serif`;
  context.textAlign = 'center';
  context.textBaseline = 'top';
  context.fillStyle = `rgb(${inks[appearance].outline.join(' ')})`;
  for (const {label, points, outline, offset} of pieces) {
    const loop = outline.flatMap((v) => points.slice(v, v + 1));
    const xs = loop.map(([x]) => x);
    const foot = Math.min(...loop.map(([, y]) => y));
    const middle = (Math.min(...xs) + Math.max(...xs)) / 2;
    const [x, y] = toScreen(view, size, [middle + offset[0], foot + offset[1]]);
    labelLines(label).forEach((line, k) => {
      context.fillText(line, x, y + 7 + k * leading * labelSize);
    });
  }
}
