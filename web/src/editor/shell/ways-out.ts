/** A failure with buttons for its remedies; each remedy is one step of the history. */
import {css, html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import {askedSymmetries, askingFor, printOf, type Design} from '../../model/design/design.js';
import type {Failure} from '../../model/base/failure.js';
import {degrees} from '../../model/geometry/vectors.js';
import {grainRule} from '../../model/design/grain-rule.js';
import {mirrorAlignment, mirrors, turnToGrain} from '../../model/print/mirror-images.js';
import {carries} from '../../model/print/repeat.js';
import type {MeasuredSymmetry, Symmetry} from '../../model/garment/symmetries.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {withGrain, withoutPin} from '../../workbench/lists/changed-options.js';
import {controls} from '../style/controls.js';
import {cleanedOptions} from '../../workbench/cleaned-options.js';
import {spokenFailure} from '../../workbench/spoken-failure.js';
import {withoutSymmetry} from '../../workbench/symmetry-steps.js';

interface Way {
  readonly label: string;
  readonly change: Partial<Design>;
}

const namesOf = (symmetry: Symmetry): readonly string[] =>
  symmetry.kind === 'piece' ? [symmetry.piece] : symmetry.pieces;

/** Greatest number of remedies; a longer list would not help. */
const mostWays = 6;

export class WaysOut extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    failure: {attribute: false},
    measured: {state: true},
  };
  declare failure: Failure;
  /** The symmetries that cause the failure, as measured on the garment. */
  declare protected measured: readonly MeasuredSymmetry[];

  static override styles = [
    controls,
    css`
      :host,
      .ways {
        display: grid;
        gap: var(--sw-space-2);
      }
      button {
        justify-content: start;
        text-align: start;
        white-space: normal;
      }
    `,
  ];

  constructor() {
    super();
    this.measured = [];
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (changed.has('failure')) void this.#measure(this.failure);
  }

  protected override render(): TemplateResult {
    const ways = this.#ways().slice(0, mostWays);
    return html`<p class="error" role="alert">${this.#words()}</p>
      ${
        ways.length === 0
          ? nothing
          : html`<div class="ways" role="group" aria-label=${this.texts.symmetry.waysOut}>
              ${ways.map(
                ({label, change}) =>
                  html`<button
                    class="outlined"
                    @click=${() => {
                      this.workbench.history.change(change);
                    }}
                  >
                    ${label}
                  </button>`,
              )}
            </div>`
      }`;
  }

  async #measure(failure: Failure): Promise<void> {
    this.measured = [];
    if (failure.code !== 'symmetryConflict') return;
    const all = await Promise.allSettled(
      this.#toBlame().map((one) => this.workbench.solving.measure(one)),
    );
    if (failure !== this.failure) return;
    this.measured = all.flatMap((one) => (one.status === 'fulfilled' ? [one.value] : []));
  }

  /** Returns the symmetries of the piece in the failure; all symmetries if the failure has none. */
  #toBlame(): readonly Symmetry[] {
    const {design} = this.workbench.history;
    const {pattern} = this.workbench.solving;
    const name = pattern?.pieces[this.failure.piece ?? -1]?.name;
    const asked = design ? askedSymmetries(design) : [];
    const own = asked.filter((one) => name !== undefined && namesOf(one).includes(name));
    return own.length > 0 ? own : asked;
  }

  #words(): string {
    const [one, more] = this.#toBlame();
    const pieces = one && !more ? this.#labels(one) : undefined;
    return spokenFailure(this.failure, this.workbench, this.texts, pieces);
  }

  #ways(): readonly Way[] {
    const {design} = this.workbench.history;
    if (!design) return [];
    const {symmetry: texts} = this.texts;
    switch (this.failure.code) {
      case 'symmetryGroup': {
        const {group} = design.print;
        const carried = askedSymmetries(design).filter(({kind}) => carries(group, kind));
        return [{label: texts.leaveOut, change: {symmetry: askingFor(carried)}}];
      }
      case 'symmetryConflict':
      case 'symmetryDoesNotMirror': {
        const kept = this.measured.flatMap((one) => [
          ...this.#againstPins(design, one),
          ...this.#againstGrain(design, one),
        ]);
        const isExplained = kept.length > 0 || this.failure.code === 'symmetryDoesNotMirror';
        const dropped = isExplained ? this.#toBlame() : askedSymmetries(design);
        return [...kept, ...dropped.map((one) => this.#dropped(design, one))];
      }
      case 'options': {
        const {pattern} = this.workbench.solving;
        const options = pattern && cleanedOptions(design.options, pattern);
        return options && options !== design.options
          ? [{label: texts.cleanUp, change: {options}}]
          : [];
      }
      default:
        return [];
    }
  }

  #label(name: string): string {
    const {pieces = []} = this.workbench.sheet.scenes?.now ?? {};
    return pieces.find((piece) => piece.name === name)?.label ?? name.replaceAll('_', ' ');
  }

  #labels(one: Symmetry): string {
    return namesOf(one)
      .map((name) => this.#label(name))
      .join(', ');
  }

  #dropped(design: Design, one: Symmetry): Way {
    return {
      label: this.texts.symmetry.dropFor(this.#labels(one)),
      change: withoutSymmetry(askedSymmetries(design), one),
    };
  }

  #againstPins({print, options}: Design, {map, ...one}: MeasuredSymmetry): readonly Way[] {
    const [first = '', second = first] = namesOf(one);
    const [pin, other] = [options.pins?.[first], options.pins?.[second]];
    if (!pin || !other || mirrors(printOf(print), map, pin, other)) return [];
    const {symmetry: texts} = this.texts;
    const names = [...new Set([first, second])];
    const image = first === second ? undefined : mirrorAlignment(printOf(print), map, pin, other);
    const snapped: Way[] = image
      ? [
          {
            label: texts.mirrorTwin(this.#label(second), this.#label(first)),
            change: {options: {...options, pins: {...options.pins, [second]: image}}},
          },
        ]
      : [];
    const freed = names.map((name) => ({
      label: texts.freePiece(this.#label(name)),
      change: {options: withoutPin(options, name)},
    }));
    return [...snapped, ...freed];
  }

  #againstGrain(design: Design, {map, ...one}: MeasuredSymmetry): readonly Way[] {
    const {print, options} = design;
    const names = namesOf(one);
    if (!carries(print.group, one.kind) || names.some((name) => options.pins?.[name])) return [];
    const {pieces = []} = this.workbench.sheet.scenes?.now ?? {};
    const [first, second = first] = names.map((name) =>
      grainRule(design, name, pieces.find((piece) => piece.name === name)?.grain),
    );
    const turn = turnToGrain(printOf(print), map, [first, second], one.kind === 'piece');
    if (turn === 0) return [];
    const {symmetry: texts} = this.texts;
    const moreDeg = degrees(turn);
    const turnDeg = ((((print.turnDeg + moreDeg + 180) % 360) + 360) % 360) - 180;
    const free = names.reduce((all, name) => withGrain(all, name, 'free'), options);
    const label = names.map((name) => this.#label(name)).join(', ');
    return [
      {label: texts.turnPrint(this.format.number(moreDeg)), change: {print: {...print, turnDeg}}},
      {label: texts.anyAngle(label), change: {options: free}},
    ];
  }
}
