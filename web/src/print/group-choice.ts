/** Choices of the gallery: the 17 groups, and stripes, which have no group of their own. */
import {groupNames} from '../model/base/core-tables.js';
import type {DesignPrint} from '../model/design/design.js';
import {type GroupName} from '../model/print/repeating-print.js';
import {alongStripe} from '../model/print/repeat.js';

export type Choice = GroupName | 'stripes';

export const choices: readonly Choice[] = [...groupNames, 'stripes'];

export const groupOf = (choice: Choice): GroupName => (choice === 'stripes' ? 'pmm' : choice);

/** Returns the print that represents a choice. */
export const sampleOf = (choice: Choice): string => (choice === 'stripes' ? 'ticking' : choice);

/** Returns the key of the text that describes a print; asymmetric stripes differ from others. */
export const meaningOf = (print: Pick<DesignPrint, 'group' | 'size'>): Choice | 'stripesOneWay' => {
  const choice = choiceOf(print);
  return choice === 'stripes' && print.group === 'pm' ? 'stripesOneWay' : choice;
};

export const choiceOf = ({group, size}: Pick<DesignPrint, 'group' | 'size'>): Choice =>
  ['pm', 'pmm'].includes(group) && size.height <= alongStripe ? 'stripes' : group;
