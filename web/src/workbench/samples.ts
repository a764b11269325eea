/** The garments and prints that come with the page. */
import {
  noPicture,
  usualSeed,
  type Design,
  type DesignGarment,
  type DesignPrint,
} from '../model/design.js';
import type {Colourway, Print} from '../model/print.js';
import {repeatOf} from '../model/repeat.js';

export interface SampleGarment {
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

/** What a page shows when nobody has chosen anything yet. */
export const opening = {style: 'asymmetric-dress', size: 'm', print: 'cm'} as const;

/** What it shows to somebody who has not been here yet: a garment whose halves mirror each other. */
export const welcome = {style: 'princess-dress', size: 'm', print: 'cm'} as const;

/** There is no network, and the file is not on this device. */
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

/** A sample print as it is shipped; an unknown colourway is the first. */
export function samplePrint(print: SamplePrint, colourway?: string): DesignPrint {
  const {name, title, group, oneWay = false, cell = 'primitive', colourways} = print;
  const shown = colourways.find((one) => one.name === colourway) ?? colourways[0];
  return {
    ...{title, group, oneWay, cell, ...repeatOf(print)},
    image: `prints/${shown?.image ?? print.image ?? ''}`,
    sample: {name, colourway: shown?.name ?? ''},
  };
}

/** The same print as it was sized and turned, in other colours. */
export function inColours(print: DesignPrint, sample: SamplePrint, colourway: string): DesignPrint {
  const {image, sample: shown} = samplePrint(sample, colourway);
  return {...print, image, ...(shown && {sample: shown})};
}

/** What is cut from when no print has been chosen. */
export const bareCloth: DesignPrint = {
  title: '',
  group: 'p4m',
  size: {width: 10, height: 10, angleDeg: 90},
  turnDeg: 0,
  oneWay: false,
  cell: 'primitive',
  image: noPicture,
};

/** A garment that somebody opens is cut on grain unless its owner wants otherwise. */
export const newDesign = (garment: DesignGarment, print: DesignPrint): Design => ({
  garment,
  print,
  symmetry: 'none',
  method: 'best',
  options: {maxChangeCm: 1, grain: {default: 'on'}},
  seed: usualSeed,
});
