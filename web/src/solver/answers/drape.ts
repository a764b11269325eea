/** Runs drapes in slices. */
import type {Drape, DrapeHooks, DrapeMesh} from '../../model/result/draped-garment.js';
import {runInSlices, type Pace} from './slices.js';
import {documentBytes, toError} from '../json/document.js';
import type {DrapeModule, ModuleDrape, ModuleDrapeRequest} from '../module/drape.mjs';
import type {DrapeInputs} from '../requests/requests.js';

/**
 * Work of one call: a few steps on a coarse mesh, one on a fine one. [factorisations of a 90 x 90
 * grid]
 */
const workAtOnce = 0.25;

/** Interval between reported positions: one or two frames of a display. [ms] */
const between = 33;

export function drapeRequest(module: DrapeModule, texts: DrapeInputs): ModuleDrapeRequest {
  const {result, body} = texts;
  return {
    ...texts,
    result: documentBytes(result, module),
    body: body === '' ? '' : documentBytes(body, module),
  };
}

/** Drapes a garment to the end. @throws {SolverError} for bad input; errors of `runInSlices` */
export async function runDrape(drape: ModuleDrape, hooks: DrapeHooks, pace: Pace): Promise<Drape> {
  let mesh: DrapeMesh | undefined;
  let stage: ReturnType<ModuleDrape['stage']> = '';
  let shown = -Infinity;
  const advance = (): boolean => {
    const more = drape.advance(workAtOnce);
    const failure = drape.failure();
    if (failure) throw toError(failure);
    return more;
  };
  const tell = () => {
    const now = drape.stage();
    if (now === '') return;
    if (stage === '') hooks.onForm?.(drape.form());
    if (stage === '' || (now === 'settle' && stage !== 'settle')) {
      mesh = drape.mesh();
      hooks.onMesh?.(mesh);
      shown = -Infinity;
    }
    stage = now;
    hooks.onProgress?.({stage: now, fraction: drape.fraction()});
    if (performance.now() - shown < between && now !== 'done') return;
    shown = performance.now();
    hooks.onPositions?.(drape.shown());
  };
  const work = (milliseconds: number): boolean => {
    const end = performance.now() + milliseconds;
    let more: boolean;
    do more = advance();
    while (more && drape.stage() === stage && performance.now() < end);
    tell();
    return more;
  };
  await runInSlices(work, pace, hooks.signal);
  return {
    mesh: mesh ?? drape.mesh(),
    positions: drape.positions(),
    form: drape.form(),
    ...drape.report(),
  };
}
