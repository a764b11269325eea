/** All shipped garments. */
import type {Body} from './body.js';
import {draftPrincessDress} from './princess-dress.js';
import {draftGatheredSkirt} from './gathered-skirt.js';
import {draftTee} from './tee.js';
import {draftSixGoreSkirt} from './six-gore-skirt.js';
import {draftTrousers} from './trousers.js';
import {draftShiftDress} from './shift-dress.js';
import {draftShirt} from './shirt.js';
import {draftAsymmetricDress} from './asymmetric-dress.js';
import {draftApron} from './apron.js';
import {draftRaglan} from './raglan.js';
import {draftHoodie} from './hoodie.js';
import {draftPatchworkJacket} from './patchwork-jacket.js';
import {draftBoxPleatedSkirt} from './box-pleated-skirt.js';
import {draftTuckedBlouse} from './tucked-blouse.js';
import type {Garment} from './panel.js';

export const wardrobe: readonly ((body: Body) => Garment)[] = [
  draftPrincessDress,
  draftTee,
  draftGatheredSkirt,
  draftSixGoreSkirt,
  draftTrousers,
  draftShiftDress,
  draftShirt,
  draftAsymmetricDress,
  draftApron,
  draftRaglan,
  draftHoodie,
  draftPatchworkJacket,
  draftBoxPleatedSkirt,
  draftTuckedBlouse,
];
