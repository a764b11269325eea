/**
 * Leaves out of three what this project never uses. All materials here bring their own shaders,
 * without `#include`; there are no lights, shadows, environments, morph targets or headsets. The
 * sources of three import those from the renderer, so no bundler can drop them.
 */
import {existsSync} from 'node:fs';
import {join, sep} from 'node:path';

import {root} from './shell.mjs';

const sources = join(root, 'node_modules/three/src');

/** Replacements of modules, by their paths in the sources of three. */
const replacements = {
  // every fragment shader begins with the conversion of colours
  'renderers/shaders/ShaderChunk.js': `
    import colorspace_pars_fragment from './ShaderChunk/colorspace_pars_fragment.glsl.js';
    export const ShaderChunk = {colorspace_pars_fragment};`,
  'renderers/shaders/ShaderLib.js': 'export const ShaderLib = {};',
  'renderers/shaders/DFGLUTData.js': 'export const getDFGLUT = () => null;',
  'renderers/webgl/WebGLEnvironments.js': `
    export function WebGLEnvironments() {
      return {get: (texture) => texture ?? null, dispose() {}};
    }`,
  'renderers/webgl/WebGLMaterials.js': `
    export function WebGLMaterials() {
      return {
        refreshFogUniforms() {},
        refreshMaterialUniforms(_, material) {
          material.uniformsNeedUpdate = false;
        },
      };
    }`,
  'renderers/webgl/WebGLMorphtargets.js': `
    export function WebGLMorphtargets() {
      return {update() {}};
    }`,
  'renderers/webgl/WebGLShadowMap.js': `
    export function WebGLShadowMap() {
      Object.assign(this, {enabled: false, render() {}});
    }`,
  'renderers/webxr/WebXRManager.js': `
    import {EventDispatcher} from '../../core/EventDispatcher.js';
    export class WebXRManager extends EventDispatcher {
      enabled = false;
      isPresenting = false;
      getEnvironmentBlendMode() {
        return undefined;
      }
      setAnimationLoop() {}
      dispose() {}
    }`,
};

/** @throws {Error} if a module to be replaced does not exist, as after an update of three */
export function leanThree() {
  const replaced = new Map(
    Object.entries(replacements).map(([path, code]) => [join(sources, path), code]),
  );
  return {
    name: 'seamwise-lean-three',
    apply: 'build',
    enforce: 'pre',
    buildStart() {
      const missing = [...replaced.keys()].find((file) => !existsSync(file));
      if (missing) this.error(`three has no ${missing} any more; see web/setup/lean-three.mjs.`);
    },
    resolveId: (name) => (name === 'three' ? join(sources, 'Three.js') : null),
    load: (id) => replaced.get(id.replaceAll('/', sep)) ?? null,
  };
}
