/** The result in one headline and a few sentences. */
import type {SeamGroup, SeamPlace} from '../../model/result/result.js';
import {
  countedGroups,
  isVisible,
  seamCount,
  type SeamCount,
  type SeamWeights,
} from '../../model/result/seam-groups.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import {firstUpper} from './names.js';

interface Judged {
  readonly groups: readonly SeamGroup[];
  readonly weights: SeamWeights;
  /** The same count for the pieces as drafted, laid on grain. */
  readonly before: SeamCount | undefined;
  /** The greatest mismatch of a counted seam. [cm] */
  readonly most: number;
}

/** "9 of 11 visible seams match" */
export function headlineOf(
  {groups, weights}: Pick<Judged, 'groups' | 'weights'>,
  {headline}: Texts,
): string {
  const {matched, counted} = seamCount(groups, weights);
  if (groups.length === 0) return headline.noSeams;
  if (counted === 0) return headline.noneMatched;
  const isHidden = !countedGroups(groups, weights).some((group) => isVisible(group, weights));
  if (matched === counted) return (isHidden ? headline.allHidden : headline.all)(counted);
  return (isHidden ? headline.someHidden : headline.some)(matched, counted);
}

/** "Without matching, 3 of them would match"; undefined if nothing is gained. */
export function gainOf({groups, weights, before}: Judged, {headline}: Texts): string | undefined {
  const {matched} = seamCount(groups, weights);
  return before && before.matched < matched ? headline.before(before.matched) : undefined;
}

/** Sentences below the headline: the places where the print matches, and those where it breaks. */
export function sentencesOf(
  {groups, weights, most}: Judged,
  {headline, places}: Texts,
  format: Format,
  language: string,
): readonly string[] {
  const counted = countedGroups(groups, weights);
  const {matched} = seamCount(groups, weights);
  if (groups.length === 0) return [headline.sew];
  if (counted.length === 0) return [headline.allLeftOut];
  if (matched === counted.length) return [headline.largest(format.fine(most))];
  const list = new Intl.ListFormat(language);
  const kinds = kindsOf(counted);
  const at = (kind: Kind): string =>
    list.format([...kinds].flatMap(([place, one]) => (one === kind ? [places[place].at] : [])));
  const said = kindNames
    .filter((kind) => [...kinds.values()].includes(kind))
    .map((kind, k) =>
      firstUpper(headline[kind](k === 0 ? headline.print : headline.it, at(kind)).trim()),
    );
  return [...said, ...(lacksMirrors(counted) ? [headline.lacksMirrors] : [])];
}

const kindNames = ['matchesAt', 'closeAt', 'partlyAt', 'breaksAt'] as const;
type Kind = (typeof kindNames)[number];

/** The kind of match at each place, in the order of the places' visibility. */
function kindsOf(groups: readonly SeamGroup[]): ReadonlyMap<SeamPlace, Kind> {
  const sorted = groups.toSorted((one, other) => other.visibility - one.visibility);
  return new Map(
    sorted.map(({place}): [SeamPlace, Kind] => {
      const some = groups.filter((group) => group.place === place);
      const count = (...wanted: readonly SeamGroup['state'][]): number =>
        some.filter(({state}) => wanted.includes(state)).length;
      if (count('matches') === some.length) return [place, 'matchesAt'];
      if (count('matches', 'close') === some.length) return [place, 'closeAt'];
      return [place, count('matches') > 0 ? 'partlyAt' : 'breaksAt'];
    }),
  );
}

/** Returns whether most of the seams that do not match would need mirrors in the print. */
function lacksMirrors(counted: readonly SeamGroup[]): boolean {
  const failed = counted.filter(({state}) => state !== 'matches');
  return 2 * failed.filter(({reason}) => reason === 'group').length > failed.length;
}
