/** Checks calls of the solver's functions by untyped code, before a request is made of them. */
import {SolverError} from '../../model/base/failure.js';
import {
  callback,
  checkArguments,
  having,
  optional,
  readable,
  signal,
} from '../../model/base/arguments.js';
import {text, type Read} from '../../model/base/read.js';

const known = having({
  signal: optional(signal),
  name: optional(text()),
  names: optional(having({})),
});

/** Accepts hooks of any function: a signal, names, and callbacks. */
const hooks: Read<object> = (value, at) => {
  const given: object = readable(known(value, at));
  for (const [name, hook] of Object.entries(given) as [string, unknown][]) {
    if (name.startsWith('on')) optional(callback)(hook, `${at}.${name}`);
  }
  return given;
};

/** @throws {SolverError} `options` for hooks of a wrong type */
export const checkHooks = (call: string, given: unknown): void => {
  checkArguments(call, ['hooks', given, hooks]);
};

/** @throws {SolverError} `options` for a problem with a part that cannot be read */
export const checkReadable = (call: string, problem: unknown): void => {
  checkArguments(call, ['problem', problem, readable]);
};

/**
 * Makes a request of the arguments of a call.
 * @throws {SolverError}, `options` for arguments of a wrong type
 */
export function requestOf<Request>(call: string, make: () => Request): Request {
  try {
    return make();
  } catch (cause) {
    if (cause instanceof SolverError) throw cause;
    const message = `${call}: a part of its arguments is of a wrong type or cannot be read.`;
    throw new SolverError({code: 'options', message}, {cause});
  }
}
