/**
 * Odd values of arguments, and of parts of arguments. The functions contain all that they need, so
 * that a test can put them into a page.
 */

/** Values that hardly any argument accepts, by label. */
export function oddValues(): Readonly<Record<string, unknown>> {
  const broken = (): never => {
    throw new Error('odd');
  };
  const cyclic: Record<string, unknown> = {};
  cyclic.self = cyclic;
  const gaps: unknown[] = [];
  gaps[3] = 1;
  const revoked = Proxy.revocable({}, {});
  revoked.revoke();
  const detached = new Uint8Array(8);
  structuredClone(detached.buffer, {transfer: [detached.buffer]});
  let [lists, objects]: [unknown, unknown] = [0, 0];
  for (let depth = 0; depth < 10_000; depth++) [lists, objects] = [[lists], {inner: objects}];
  // pages have none unless they are isolated
  const shared =
    'SharedArrayBuffer' in globalThis ? {shared: new Uint8Array(new SharedArrayBuffer(8))} : {};
  return {
    ...{undefined, null: null, true: true, zero: 0, '-0': -0, '-1': -1, '1.5': 1.5, NaN, Infinity},
    ...{'-Infinity': -Infinity, '1e308': 1e308, '9e8': 9e8, '1e-320': 1e-320, '2^53': 2 ** 53},
    ...{empty: '', blank: ' ', letter: 'x', proto: '__proto__', long: '9'.repeat(100_000)},
    ...{surrogate: '\ud800', zeroByte: '\0', symbol: Symbol('odd'), symbols: [Symbol('odd')]},
    ...{bigint: 5n, function: () => 1, boxed: Object(1) as unknown, regex: /x/},
    ...{'[]': [], '[null]': [null], '[NaN]': [NaN], '{}': {}, '{a: 1}': {a: 1}, '[[[]]]': [[[]]]},
    ...{gaps, endless: new Array<unknown>(2 ** 32 - 1), cyclic, lists, objects},
    ...{date: new Date(NaN), map: new Map([[1, 2]]), set: new Set([1]), error: new Error('odd')},
    ...{bare: Object.create(null) as unknown, frozen: Object.freeze([Object.freeze({})])},
    ...{bytes: new Uint8Array([1, 2, 3]), floats: new Float32Array([NaN]), detached, ...shared},
    ...{buffer: new ArrayBuffer(8), view: new DataView(new ArrayBuffer(8))},
    ...{bigints: new BigInt64Array(2), promise: Promise.resolve(1), revoked: revoked.proxy},
    proxy: new Proxy({}, {get: broken, ownKeys: broken, getPrototypeOf: broken}),
    getter: Object.defineProperty({}, 'odd', {enumerable: true, get: broken}),
    ...{toJSON: {toJSON: broken}, toString: {toString: broken}},
  };
}

/** Paths of all parts of a value; of a list, those of its first entry. */
export function partsOf(value: unknown): readonly (readonly string[])[] {
  if (typeof value !== 'object' || value === null || ArrayBuffer.isView(value)) return [];
  const names = Array.isArray(value) ? Object.keys(value).slice(0, 1) : Object.keys(value);
  return names.flatMap((name) => [
    [name],
    ...partsOf(Reflect.get(value, name)).map((path) => [name, ...path]),
  ]);
}

/** A copy of a value with another part. */
export function withPart(value: unknown, path: readonly string[], part: unknown): unknown {
  const [name, ...inner] = path;
  if (name === undefined) return part;
  const copy: object = Array.isArray(value) ? [...(value as unknown[])] : {...(value as object)};
  return Object.defineProperty(copy, name, {
    ...{enumerable: true, writable: true, configurable: true},
    value: withPart(Reflect.get(value as object, name), inner, part),
  });
}

/**
 * Returns what is wrong with the outcome of a call; empty for a value or a proper error.
 * @param codes known codes of errors
 */
export async function faultOf(call: () => unknown, codes: readonly string[]): Promise<string> {
  try {
    await call();
    return '';
  } catch (error) {
    const {code, message} = error as {code?: string; message?: string};
    if (code === undefined || code === 'internal' || !codes.includes(code)) {
      return `${String(code)} ${String(error)}`;
    }
    return /^\S[^\n]*\.$/.test(message ?? '') ? '' : `no sentence: ${String(message)}`;
  }
}
