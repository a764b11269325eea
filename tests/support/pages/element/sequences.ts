/** Random sequences of a page's actions on an element, reproducible by their seed. */
import type {SeamwiseGarment} from '@/element/seamwise-garment.js';
import {resultText, sha256Of} from '@/model/documents/result-text.js';

const prints = ['prints/p4m.json', 'prints/cm.json', 'prints/p1.json'];
const garments = ['garments/strips-{size}.json', 'garments/strips-m.json'];
const pair = {kind: 'pair', pieces: ['left', 'right']};

export interface Sequence {
  readonly seed: number;
  readonly steps: readonly string[];
  /** Descriptions of violations. */
  readonly wrong: readonly string[];
}

/** Numbers from 0 to 1, the same for the same seed: mulberry32. */
function randomFrom(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

const rest = (time: number): Promise<unknown> =>
  new Promise((resolve) => setTimeout(resolve, time));

const nameOf = (error: unknown): string => {
  const {name, code} = error as {name: string; code: unknown};
  return typeof code === 'string' ? code : name;
};

/**
 * Possible outcomes of a promise: an answer, cancelled, no garment, or a print without that
 * symmetry.
 */
const allowed = /^(answer|AbortError|notAGarment|symmetryGroup)$/;

/** Outcome of the element's solve, and the design, where it can be stored. */
async function outcomeOf(element: SeamwiseGarment): Promise<string> {
  try {
    const result = await element.solve();
    if (element.state !== 'ready') return `answered, but ${element.state}`;
    return `answer ${sha256Of(resultText(result))} ${element.value}`;
  } catch (error) {
    return nameOf(error);
  }
}

/** Another element that only gets the last state. */
function twinOf(element: SeamwiseGarment): SeamwiseGarment {
  const twin = document.createElement('seamwise-garment');
  for (const name of element.getAttributeNames()) {
    twin.setAttribute(name, element.getAttribute(name) ?? '');
  }
  for (const name of ['garment', 'print', 'symmetry'] as const) {
    const value: unknown = element[name];
    if (typeof value === 'object') Reflect.set(twin, name, value);
  }
  return twin;
}

const answers = new Map<string, Promise<string>>();

/** Expected outcome; solved once for each state. */
function expected(element: SeamwiseGarment): Promise<string> {
  const twin = twinOf(element);
  const asked = ['garment', 'size', 'print', 'colourway', 'symmetry', 'maxChangeMm'] as const;
  const key = JSON.stringify(asked.map((name) => twin[name]));
  let answer = answers.get(key);
  if (!answer) {
    answer = outcomeOf(twin);
    answers.set(key, answer);
  }
  return answer;
}

async function picture(element: SeamwiseGarment): Promise<Uint8ClampedArray | undefined> {
  let blob: Blob | undefined;
  for (let k = 0; k < 100 && !blob; k++) {
    blob = await element.toBlob({width: 200}).catch(() => undefined);
    if (!blob) await rest(50); // not drawn yet
  }
  if (!blob) return undefined;
  const bitmap = await createImageBitmap(blob);
  const {width, height} = bitmap;
  const context = new OffscreenCanvas(width, height).getContext('2d');
  context?.drawImage(bitmap, 0, 0);
  return context?.getImageData(0, 0, width, height).data;
}

/**
 * Describes the difference of two images; undefined if they are equal, except for an SVG's
 * resolution.
 */
function unlike(
  a: Uint8ClampedArray | undefined,
  b: Uint8ClampedArray | undefined,
): string | undefined {
  if (!a || !b) return `no picture of the ${a ? 'twin' : 'element'}`;
  if (a.length !== b.length) return `a picture of ${a.length} values in the place of ${b.length}`;
  const mean = a.reduce((sum, value, k) => sum + Math.abs(value - (b[k] ?? 0)), 0) / a.length;
  return mean < 4 ? undefined : `another picture, by ${mean.toFixed(1)} levels`;
}

/** @param holder  parent of everything that is put into the page */
export async function sequence(seed: number, holder: HTMLElement): Promise<Sequence> {
  const next = randomFrom(seed);
  const below = (most: number): number => Math.floor(next() * most);
  const one = <T>(of: readonly [T, ...T[]] | readonly T[]): T => of[below(of.length)] as T;
  const [steps, wrong]: [string[], string[]] = [[], []];
  const pending: Promise<unknown>[] = [];
  const form = document.createElement('form');
  const aside = document.createElement('section');
  aside.attachShadow({mode: 'open'});
  holder.append(form, aside);
  const element = document.createElement('seamwise-garment');
  Object.assign(element, {garment: garments[0], size: 'm', print: one(prints), name: 'design'});
  element.loading = one(['lazy', 'eager']);
  form.append(element);

  const follow = (what: string, promise: Promise<unknown>): void => {
    let clock: ReturnType<typeof setTimeout> | undefined;
    const late = new Promise<string>((resolve) => {
      clock = setTimeout(() => {
        resolve('nothing for a minute');
      }, 60_000);
    });
    const settled = promise.then(() => 'answer', nameOf);
    pending.push(
      Promise.race([settled, late]).then((heard) => {
        clearTimeout(clock);
        if (!allowed.test(heard)) wrong.push(`${what}: ${heard}`);
      }),
    );
  };
  const read = async (path: string): Promise<object> =>
    (await (await fetch(path)).json()) as object;
  const designs: string[] = [];
  const write = (name: string, values: readonly (string | null)[]): string => {
    const value = one(values);
    if (value === null) element.removeAttribute(name);
    else element.setAttribute(name, value);
    return `${name}=${String(value)}`;
  };
  const actions: readonly (() => string | Promise<string>)[] = [
    () => write('garment', garments),
    () => write('size', ['s', 'm', 'l']),
    () => write('print', [...prints, ...prints, null]),
    () => write('colourway', ['Night', 'Mist', 'none such', null]),
    () => write('symmetry', ['auto', 'none', null]),
    () => write('mode', ['preview', 'preview', 'preview', 'place', 'edit', 'dance']),
    () => write('units', ['cm', 'inch']),
    () => write('locale', ['de', 'en', null]),
    () => write('max-change-mm', ['3', '8', '10', 'lots']),
    () => write('disabled', ['', null]),
    async () => {
      element.garment = (await read('garments/strips-l.json')) as typeof element.garment;
      return 'garment as an object';
    },
    async () => {
      const image = new URL('prints/p4m.svg', document.baseURI).href;
      const file = await read('prints/p4m.json');
      Reflect.set(element, 'print', {...file, image, colourways: undefined});
      return 'print as an object';
    },
    () => {
      element.symmetry = one([[pair], {symmetries: []}]) as typeof element.symmetry;
      return 'symmetry as an object';
    },
    () => {
      const late = new AbortController();
      const time = below(60);
      setTimeout(() => {
        late.abort();
      }, time);
      follow('aborted solve', element.solve({signal: late.signal}));
      return `solve, aborted after ${time} ms`;
    },
    () => {
      follow('solve', element.solve());
      return 'solve';
    },
    () => {
      element.cancel();
      return 'cancel';
    },
    () => {
      const {value} = element;
      if (value) designs.push(value);
      const design = designs.length > 0 ? one(designs) : undefined;
      if (design) follow('setDesign', element.setDesign(design));
      return design ? 'setDesign' : 'no design yet';
    },
    () => {
      form.reset();
      return 'reset';
    },
    () => {
      element.remove();
      return 'removed';
    },
    () => {
      one([form, aside.shadowRoot])?.append(element);
      return 'put in again';
    },
  ];
  const count = 5 + below(6);
  for (let k = 0; k < count; k++) {
    steps.push(await one(actions)());
    if (next() < 0.7) await rest(one([0, 0, 1, 5, 20, 60]));
  }
  if (element.print === '') element.print = prints[0];
  const isHere = next() < 0.7;
  if (isHere) form.append(element);
  else element.remove();
  const last = designs.at(-1);
  if (last !== undefined && next() < 0.2) {
    // a design with more than the attributes contain
    const stored = JSON.parse(last) as {seed: number; print: object};
    const changed = JSON.stringify({
      ...{...stored, seed: 7},
      print: {...stored.print, size: {width: 6, height: 6, angleDeg: 90}},
    });
    steps.push('setDesign with changes');
    await element.setDesign(changed);
    const twin = twinOf(element);
    await twin.setDesign(changed);
    if ((await outcomeOf(element)) !== (await outcomeOf(twin))) wrong.push('another design');
  } else {
    const found = await outcomeOf(element);
    const wanted = await expected(element);
    if (found !== wanted) wrong.push(`${found.slice(-600)} in the place of ${wanted.slice(-600)}`);
    if (isHere && seed % 10 === 0 && wanted.startsWith('answer') && element.mode === 'preview') {
      const twin = twinOf(element);
      twin.loading = 'eager';
      form.append(twin);
      const difference = unlike(await picture(element), await picture(twin));
      if (difference) wrong.push(difference);
    }
  }
  await Promise.all(pending);
  form.remove();
  aside.remove();
  return {seed, steps, wrong};
}
