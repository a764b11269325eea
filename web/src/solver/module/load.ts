/**
 * The build puts a module's .mjs and .wasm beside this file, both in the sources and in `dist`. If
 * any server serves them unchanged, the files are neighbours; bundlers know the expressions below
 * and emit the files. Neither case needs a setting; only Node has to read the .wasm files itself.
 */
import type {ModuleLoader} from './shared-module.js';
import type {DrapeModule} from './drape.mjs';
import type {MarkerModule} from './marker.mjs';
import type {ModuleSettings} from './module.js';
import type {PhotoModule} from './photo.mjs';
import createSeamwise, {type SeamwiseModule} from './seamwise.mjs';

export const seamwise: ModuleLoader<SeamwiseModule> = {
  file: 'seamwise.wasm',
  url: new URL('./seamwise.wasm', import.meta.url),
  create: (compiled) => instance(createSeamwise, compiled),
};

/** Fetched, including the script, when a garment is first draped. */
export const drape: ModuleLoader<DrapeModule> = {
  file: 'drape.wasm',
  url: new URL('./drape.wasm', import.meta.url),
  create: async (compiled) => instance((await import('./drape.mjs')).default, compiled),
};

/** Fetched, including the script, when pieces are first laid out on fabric. */
export const marker: ModuleLoader<MarkerModule> = {
  file: 'marker.wasm',
  url: new URL('./marker.wasm', import.meta.url),
  create: async (compiled) => instance((await import('./marker.mjs')).default, compiled),
};

/** Fetched, including the script, when a print is first read from an image. */
export const photo: ModuleLoader<PhotoModule> = {
  file: 'photo.wasm',
  url: new URL('./photo.wasm', import.meta.url),
  create: async (compiled) => instance((await import('./photo.mjs')).default, compiled),
};

function instance<M>(
  create: (settings: ModuleSettings) => Promise<M>,
  compiled: WebAssembly.Module,
): Promise<M> {
  return new Promise((resolve, reject) => {
    const instantiateWasm: ModuleSettings['instantiateWasm'] = (imports, receive) => {
      WebAssembly.instantiate(compiled, imports).then(receive, reject);
      return {};
    };
    create({instantiateWasm}).then(resolve, reject);
  });
}
