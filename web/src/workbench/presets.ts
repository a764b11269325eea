/** Presets for makers, each a set of solver settings. */
import type {GrainLock} from '../model/garment/grain.js';
import type {Design} from '../model/design/design.js';
import type {SolveOptions} from '../model/design/options.js';
import type {Method} from '../model/result/method.js';

export const presetNames = ['homeSewist', 'wovenShirt', 'bestFit', 'placeOnly'] as const;
type PresetName = (typeof presetNames)[number];

/** Settings of alignment and deformation; all are explicit, even those equal to the default. */
export interface SolveSettings {
  readonly maxChangeCm: number;
  readonly grain: GrainLock;
  readonly continuousOnly: boolean;
  readonly method: Method;
}

const usual = {continuousOnly: false, method: 'best'} as const;

const presets: Readonly<Record<PresetName, SolveSettings>> = {
  homeSewist: {...usual, grain: 'on', maxChangeCm: 1},
  wovenShirt: {...usual, grain: 'on', maxChangeCm: 0.4},
  bestFit: {...usual, grain: 'free', maxChangeCm: 1},
  placeOnly: {...usual, grain: 'on', maxChangeCm: 0},
};

export const solveSettingsOf = ({method, options}: Design): SolveSettings => ({
  maxChangeCm: options.maxChangeCm ?? 1,
  grain: options.grain?.default ?? 'free',
  continuousOnly: options.continuousOnly ?? false,
  method,
});

/** Replaces the settings; options of single pieces and seams stay. */
export function withSolveSettings(
  {options}: Design,
  {maxChangeCm, grain, continuousOnly, method}: SolveSettings,
): {readonly method: Method; readonly options: SolveOptions} {
  return {
    method,
    options: {...options, maxChangeCm, continuousOnly, grain: {...options.grain, default: grain}},
  };
}

export const withPreset = (
  design: Design,
  name: PresetName,
): ReturnType<typeof withSolveSettings> => withSolveSettings(design, presets[name]);

export function presetOf(design: Design): PresetName | undefined {
  const settings = JSON.stringify(solveSettingsOf(design));
  return presetNames.find(
    (name) =>
      JSON.stringify(solveSettingsOf({...design, ...withPreset(design, name)})) === settings,
  );
}
