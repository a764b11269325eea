/** Checks of settings that several files of this folder share. */
import {bytes, checkedLater, date, fields, having, type Checks} from '../model/base/arguments.js';
import {dxfStyles, dxfUnits, type DxfFormat} from '../model/base/dxf-format.js';
import {fail, flag, listOf, oneOf, text, type Read} from '../model/base/read.js';
import type {DxfOptions} from '../cutting/out/sheet-dxf.js';
import type {GlbOptions} from '../files/glb/glb.js';
import type {SizeSheet} from '../paper/several-sizes.js';
import type {DrapeSettings} from '../model/result/draped-garment.js';
import {jsonText} from '../solver/requests/requests.js';
import {cutSheet, drape, print} from './document-checks.js';

const word = text();
export const title = text(/\S/, 'text that is not blank');

/** Accepts an object that JSON can hold. @throws {SolverError} `notJson` or `number` */
export const json: Read<object> = (value, at) => {
  if (ArrayBuffer.isView(value)) fail(at, 'an object');
  jsonText(having({})(value, at), at);
  return value as object;
};

export const dxfFormat: Checks<DxfFormat> = {style: oneOf(dxfStyles), unit: oneOf(dxfUnits)};

export const dxfOptions = fields<DxfOptions>({
  ...{...dxfFormat, sewAsBoundary: flag, date, size: word, mark: title},
  otherSizes: listOf(cutSheet),
});

/** The other sizes of a PDF. */
export const otherSizes = listOf(having<SizeSheet>({sheet: cutSheet, print}));

export const layPlanDxf = fields<DxfFormat>(dxfFormat);

/** `drapeTexts` and the core check the other settings. */
export const drapeSettings = fields<DrapeSettings>({
  ...{fabric: checkedLater, size: checkedLater, body: checkedLater, effort: checkedLater},
  from: drape,
});

export const glbOptions = fields<GlbOptions>({
  picture: fields({bytes, type: oneOf(['image/png', 'image/jpeg'])}, 'bytes', 'type'),
  ...{plain: listOf(word), attributes: flag, form: flag, garment: word, sha256: word},
});
