/** Garments and prints that come with the page. */
import {
  noPicture,
  usualSeed,
  type Design,
  type DesignGarment,
  type DesignPrint,
} from '../model/design/design.js';
import type {Colourway, Print} from '../model/print/repeating-print.js';
import {repeatOf} from '../model/print/repeat.js';

interface SampleGarment {
  readonly style: string;
  readonly title: string;
  readonly sizes: readonly string[];
}

export interface SamplePrint extends Print {
  readonly name: string;
  readonly title: string;
  readonly colourways: readonly Colourway[];
}

export interface Samples {
  readonly garments: readonly SampleGarment[];
  readonly prints: readonly SamplePrint[];
}

/** Sample that a page shows before the user has chosen one. */
export const opening = {style: 'asymmetric-dress', size: 'm', print: 'cm'} as const;

/** Sample for a user's first visit: a garment whose halves mirror each other. */
export const welcome = {style: 'six-gore-skirt', size: 'm', print: 'cm'} as const;

/** Error for a file that is not on this device while there is no network. */
export class Unreachable extends Error {
  override readonly name = 'Unreachable';
}

async function fetched(path: string, signal?: AbortSignal): Promise<Response> {
  const response = await fetch(path, signal ? {signal} : {}).catch(() => undefined);
  signal?.throwIfAborted();
  if (!response) throw new Unreachable(`${path} cannot be reached; check the connection.`);
  if (!response.ok) throw new Error(`${path} cannot be read; load the page again.`);
  return response;
}

export async function loadSamples(): Promise<Samples> {
  return (await (await fetched('samples.json')).json()) as Samples;
}

export async function sampleGarment(
  style: string,
  size: string,
  signal?: AbortSignal,
): Promise<DesignGarment> {
  const name = `${style}-${size}.json`;
  const text = await (await fetched(`garments/${name}`, signal)).text();
  return {name, text, sample: {style, size}};
}

/** A sample print as shipped; an unknown colourway means the first one. */
export function samplePrint(print: SamplePrint, colourway?: string): DesignPrint {
  const {name, title, group, oneWay = false, cell = 'primitive', colourways} = print;
  const shown = colourways.find((one) => one.name === colourway) ?? colourways[0];
  return {
    ...{title, group, oneWay, cell, ...repeatOf(print)},
    image: `prints/${shown?.image ?? print.image ?? ''}`,
    sample: {name, colourway: shown?.name ?? ''},
  };
}

/** The same print with its size and turn, in another colourway. */
export function inColours(print: DesignPrint, sample: SamplePrint, colourway: string): DesignPrint {
  const {image, sample: shown} = samplePrint(sample, colourway);
  return {...print, image, ...(shown && {sample: shown})};
}

/** Fabric of a design without a chosen print. */
export const bareFabric: DesignPrint = {
  title: '',
  group: 'p4m',
  size: {width: 10, height: 10, angleDeg: 90},
  turnDeg: 0,
  oneWay: false,
  cell: 'primitive',
  image: noPicture,
};

/** Design of an opened garment. It is cut on grain until the user changes that. */
export const newDesign = (garment: DesignGarment, print: DesignPrint): Design => ({
  garment,
  print,
  symmetry: 'none',
  method: 'best',
  options: {maxChangeCm: 1, grain: {default: 'on'}},
  seed: usualSeed,
});
