/** Checks requests to the solver, which may come from another thread or from untyped code. */
import {having} from '../../model/base/arguments.js';
import {fail, number, oneOf, text, type Read} from '../../model/base/read.js';
import {methods} from '../../model/result/method.js';
import type {GarmentTexts, MirrorTexts, ProblemTexts, Requests} from './requests.js';

/** Requests whose checks load with the first of them. */
export type LaterKind = 'drape' | 'marker' | 'photo' | 'photoTile' | 'photoObject';

/** The checks of some kinds of requests. */
export type RequestChecks<K extends keyof Requests> = {
  readonly [Kind in K]: Read<Requests[Kind]['request']>;
};

export const word = text();
export const seed = number(0, 0xffffffff);

export const numbers: Read<Float64Array> = (value, at) =>
  value instanceof Float64Array ? value : fail(at, 'a Float64Array');

const problem = having<ProblemTexts>({
  ...{garment: word, garmentName: word, print: word, printName: word, symmetry: word},
  ...{symmetryName: word, options: word, optionsName: word, method: oneOf(methods), seed},
});

const garment = having<GarmentTexts>({garment: word, name: word});
const mirror = having<MirrorTexts>({garment: word, name: word, symmetries: word});

/** The check of each kind of request to the solver's own module. */
export const requestChecks: RequestChecks<Exclude<keyof Requests, LaterKind>> = {
  ...{solve: problem, prepare: problem, prove: problem},
  ...{mirror, symmetries: garment, garment, convert: garment},
  share: having<{readonly order: Float64Array}>({order: numbers}),
  memory: having({}),
};
