/** A design made of samples as the fragment of an address, to be passed on. */
import type {Design, DesignGarment, DesignPrint} from './design.js';
import {decisions, garmentSample, printMeasures, printSample} from './design-reader.js';
import {Malformed, shape} from './read.js';

/** All of a design but what the samples themselves hold. */
export interface LinkedDesign extends Pick<Design, 'symmetries' | 'method' | 'options'> {
  readonly garment: NonNullable<DesignGarment['sample']>;
  readonly print: Pick<DesignPrint, 'group' | 'size' | 'turnDeg' | 'oneWay' | 'cell'> & {
    readonly sample: NonNullable<DesignPrint['sample']>;
  };
}

const start = '#design=';
/** Longer ones are none of ours. */
const greatestLength = 200_000;

const linked = shape({
  garment: garmentSample,
  print: (value, at) => ({...printMeasures(value, at), ...shape({sample: printSample})(value, at)}),
});

function encoded(text: string): string {
  const bytes = Array.from(new TextEncoder().encode(text), (byte) => String.fromCodePoint(byte));
  return btoa(bytes.join('')).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

function decoded(base64: string): string {
  const bytes = atob(base64.replaceAll('-', '+').replaceAll('_', '/'));
  const codes = Uint8Array.from(bytes, (byte) => byte.codePointAt(0) ?? 0);
  return new TextDecoder('utf-8', {fatal: true}).decode(codes);
}

/** "#...", or undefined when the design holds files of the user's own. */
export function linkOf({garment, print, symmetries, method, options}: Design): string | undefined {
  if (!garment.sample || !print.sample) return undefined;
  const {group, size, turnDeg, oneWay, cell, sample} = print;
  const design: LinkedDesign = {
    garment: garment.sample,
    print: {group, size, turnDeg, oneWay, cell, sample},
    ...{symmetries, method, options},
  };
  return start + encoded(JSON.stringify(design));
}

/** Undefined for a fragment that is no design, or not a sound one. */
export function readLink(fragment: string): LinkedDesign | undefined {
  if (!fragment.startsWith(start) || fragment.length > greatestLength) return undefined;
  try {
    const value: unknown = JSON.parse(decoded(fragment.slice(start.length)));
    return {...linked(value, ''), ...decisions(value, '')};
  } catch (error) {
    // no base64, no UTF-8, no JSON, no design
    if (error instanceof DOMException || error instanceof TypeError) return undefined;
    if (error instanceof SyntaxError || error instanceof Malformed) return undefined;
    throw error;
  }
}
