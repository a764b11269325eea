/**
 * Compares sizes and turns of the print of a solved design in idle time. Fabric that is printed on
 * demand can have any of them.
 */
import {garmentsOnFabric, type Design, type DesignPrint} from '../model/design/design.js';
import {readPrintFile} from '../model/print/read-print-file.js';
import {variantBetween, variedRepeat, type PrintVariant} from '../model/print/print-variant.js';
import {repeatOf, type PrintRepeat} from '../model/print/repeat.js';
import type {GroupName} from '../model/print/repeating-print.js';
import {together} from '../model/result/visible-seams.js';
import {scalesOf} from '../solver/search/asked-search.js';
import {IdleSearch, type VariantSearch} from './idle-search.js';
import {betterThan, type IdleSolver} from './idle-solver.js';
import type {Candidate} from './known-answers.js';
import {hasOtherSizes} from './other-sizes.js';

/** Compared sizes, as multiples of the print's own size. */
const range = {from: 0.9, to: 1.1};
/** Compared turns. [degrees] */
const turns = [0, 45, 90];
/** Groups of prints that look the same after a quarter turn. */
const quarterTurns: ReadonlySet<GroupName> = new Set<GroupName>(['p4', 'p4m', 'p4g']);

/** A size or turn of the print with its answer. */
export interface VariantAnswer extends Candidate {
  readonly variant: PrintVariant;
}

/** Answers so far. */
export interface PrintComparison {
  readonly isRunning: boolean;
  readonly present: VariantAnswer;
  /** The present turn in all sizes, the smallest first. */
  readonly sizes: readonly VariantAnswer[];
  /** The present size in all turns. */
  readonly turns: readonly VariantAnswer[];
  /** A size or turn in which more visible seams match. */
  readonly better: VariantAnswer | undefined;
}

/** Pieces that lie at any angle need no turn of the print. */
const turnsFor = ({options, print}: Design): readonly number[] => {
  const {default: grain = 'free'} = options.grain ?? {};
  if (grain === 'free') return [0];
  return turns.filter((turn) => turn !== 90 || !quarterTurns.has(print.group));
};

const fileRepeats = new WeakMap<object, PrintRepeat>();

/** The repeat of the print's file, or the one before a choice. */
function givenRepeat({file, own}: DesignPrint): PrintRepeat | undefined {
  if (!file) return own;
  const known = fileRepeats.get(file) ?? repeatOf(readPrintFile(file.text, file.place?.url ?? ''));
  fileRepeats.set(file, known);
  return known;
}

/** The variants of a design's print, and the present one. */
class Variants {
  readonly present: PrintVariant;
  readonly scales: readonly number[];
  readonly turns: readonly number[];
  readonly #design: Design;
  readonly #own: PrintRepeat;

  constructor(design: Design, offered: readonly number[] | undefined) {
    this.#design = design;
    const {size, turnDeg} = design.print;
    const scales = offered ? [1, ...offered] : scalesOf(range);
    const allTurns = offered ? [0] : turnsFor(design);
    const given = givenRepeat(design.print);
    const variant = given && variantBetween(given, {size, turnDeg});
    const isNear =
      variant &&
      variant.scale >= Math.min(...scales) &&
      variant.scale <= Math.max(...scales) &&
      allTurns.includes(variant.turnDeg);
    this.#own = isNear ? given : {size, turnDeg};
    this.present = isNear ? variant : {scale: 1, turnDeg: 0};
    this.scales = [...new Set([this.present.scale, ...scales])];
    this.turns = [...new Set([this.present.turnDeg, ...allTurns])];
  }

  design(variant: PrintVariant): Design {
    const {scale, turnDeg} = this.present;
    if (variant.scale === scale && variant.turnDeg === turnDeg) return this.#design;
    const {print} = this.#design;
    const isOwn = variant.scale === 1 && variant.turnDeg === 0;
    const own = isOwn || print.file ? undefined : this.#own;
    const varied = {...print, ...variedRepeat(this.#own, variant), own};
    return {...this.#design, print: varied};
  }
}

/** The other garments on the fabric of a design. */
const besideOf = (design: Design): readonly Design[] => garmentsOnFabric(design).slice(1);

export class PrintSizes extends IdleSearch {
  /**
   * Sizes that a shop offers, as multiples of the print's own size; it offers no turns. Undefined
   * without a shop: usual sizes, and turns.
   */
  readonly #offered: () => readonly number[] | undefined;

  constructor(
    solver: IdleSolver,
    changed: () => void,
    offered: () => readonly number[] | undefined,
  ) {
    super(solver, changed);
    this.#offered = offered;
  }

  /** Undefined until another size or turn is being solved. */
  of(design: Design): PrintComparison | undefined {
    if (!hasOtherSizes(design, this.#offered())) return undefined;
    const variants = new Variants(design, this.#offered());
    const {scale, turnDeg} = variants.present;
    const answer = (variant: PrintVariant): readonly VariantAnswer[] => {
      const varied = variants.design(variant);
      const all = [varied, ...besideOf(varied)].flatMap((one) => this.solver.known.of(one) ?? []);
      const isWhole = all.length === 1 + (varied.added?.length ?? 0);
      const standing = together(all.map((one) => one.standing));
      return isWhole ? [{design: varied, standing, variant}] : [];
    };
    const sizes = ascending(variants.scales).flatMap((one) => answer({scale: one, turnDeg}));
    const all = ascending(variants.turns).flatMap((one) => answer({scale, turnDeg: one}));
    const present = sizes.find(({variant}) => variant.scale === scale);
    const isRunning = this.isRunning(design);
    if (!present || (!isRunning && sizes.length + all.length <= 2)) return undefined;
    return {isRunning, present, sizes, turns: all, better: betterThan(present, [...sizes, ...all])};
  }

  protected override searches(design: Design): readonly VariantSearch[] {
    if (!hasOtherSizes(design, this.#offered())) return [];
    const variants = new Variants(design, this.#offered());
    const {scale, turnDeg} = variants.present;
    const designOf = (variant: PrintVariant): Design => variants.design(variant);
    const common = {
      ...{isLong: false, seed: design.seed, designOf},
      besideOf: (variant: PrintVariant) => besideOf(designOf(variant)),
    };
    return [
      {...common, scales: variants.scales, turns: [turnDeg]},
      {...common, scales: [scale], turns: variants.turns},
    ];
  }
}

const ascending = (values: readonly number[]): readonly number[] =>
  values.toSorted((a, b) => a - b);
