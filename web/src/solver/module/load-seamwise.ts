/**
 * The build puts seamwise.mjs and seamwise.wasm beside this file, in sources and in `dist` alike: served as they are,
 * by a development server or any other, the files are neighbours, and bundlers know the expression below and emit
 * the file. So neither needs a setting; only Node has to read the file itself.
 */
import type {ModuleLoader} from '../answers/shared-module.js';
import createSeamwise, {type SeamwiseModule} from './seamwise.mjs';

export const seamwise: ModuleLoader<SeamwiseModule> = {
  file: 'seamwise.wasm',
  url: new URL('./seamwise.wasm', import.meta.url),
  create: (compiled) =>
    new Promise((resolve, reject) => {
      const instantiateWasm = (
        imports: WebAssembly.Imports,
        receive: (instance: WebAssembly.Instance) => void,
      ) => {
        WebAssembly.instantiate(compiled, imports).then(receive, reject);
        return {};
      };
      createSeamwise({instantiateWasm}).then(resolve, reject);
    }),
};
