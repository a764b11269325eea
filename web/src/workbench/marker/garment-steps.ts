/** Steps of the design that change the garments on its fabric. */
import {
  decisionsOf,
  garmentsOnFabric,
  mostAdded,
  type AddedGarment,
  type Design,
  type DesignGarment,
} from '../../model/design/design.js';
import type {Workbench} from '../workbench.js';

type Source = Pick<Workbench, 'history'>;

/** The garments of another design, for the fabric of the present one. */
export const addedFrom = (design: Design): readonly AddedGarment[] =>
  garmentsOnFabric(design).map((one) => ({
    ...decisionsOf(one),
    ...{garment: one.garment, copies: one.copies},
  }));

/** The present garment in another size, with all decisions about it. */
export const otherSize = (design: Design, garment: DesignGarment): AddedGarment => ({
  ...decisionsOf(design),
  ...{garment, copies: 1},
});

/** Adds garments, as one step, as far as there is room. @returns the number of added garments */
export function addGarments({history}: Source, garments: readonly AddedGarment[]): number {
  const {added = []} = history.design ?? {};
  const taken = garments.slice(0, mostAdded - added.length);
  if (taken.length > 0) history.change({added: [...added, ...taken]});
  return taken.length;
}

/** @param which index of the garment on the fabric; 0 is the design's own */
function changeAdded(
  {history}: Source,
  which: number,
  changed: (one: AddedGarment) => readonly AddedGarment[],
  kind = '',
): void {
  const {added = []} = history.design ?? {};
  history.change(
    {added: added.flatMap((one, k) => (k + 1 === which ? changed(one) : [one]))},
    kind,
  );
}

export function setCopies(source: Source, which: number, copies: number): void {
  const kind = `copies ${which}`;
  if (which === 0) source.history.change({copies}, kind);
  else changeAdded(source, which, (one) => [{...one, copies}], kind);
}

export function setGarment(source: Source, which: number, garment: DesignGarment): void {
  changeAdded(source, which, (one) => [{...one, garment}]);
}

export function removeGarment(source: Source, which: number): void {
  changeAdded(source, which, () => []);
}
