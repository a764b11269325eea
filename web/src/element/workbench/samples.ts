/** The garments and prints that come with the page. */
import type {Design, DesignGarment, DesignPrint} from '../../model/design.js';
import type {Colourway, Print} from '../../model/print.js';
import {repeatOf} from '../../model/repeat.js';

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

/** What a page shows when nobody has chosen anything yet; any angle, to show what can be had. */
export const opening = {
  ...{style: 'raglan', size: 'm', print: 'p4m'},
  options: {maxChangeCm: 1, grain: {default: 'free'}},
} as const;

async function fetched(path: string, signal?: AbortSignal): Promise<Response> {
  const response = await fetch(path, signal ? {signal} : {});
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

/** Of a garment that somebody opens: cut on grain unless its owner wants otherwise. */
export const firstOptions: Design['options'] = {maxChangeCm: 1, grain: {default: 'on'}};
