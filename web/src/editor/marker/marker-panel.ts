/**
 * Panel beside the fabric layout: length to buy, fields of the fabric, and a list of the pieces.
 */
import {html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import {isOfPhases} from '../../model/result/lay-note.js';
import type {CheaperDesign, LayPlan} from '../../model/result/marker-plan.js';
import type {LayStep} from '../../workbench/marker/lay-step.js';
import {saidNote} from '../../marker/draw/note-texts.js';
import {planTextsIn} from '../../texts/plan-texts.js';
import {section} from '../controls/section.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {deliveredFields} from './delivered-fields.js';
import {MarkerElement} from './marker-element.js';
import {markerFields} from './marker-fields.js';
import {
  costOfLength,
  costWords,
  leastCost,
  lengthRange,
  placeWords,
  roundedLength,
  soldLength,
} from '../../workbench/marker/marker-words.js';
import {onDelivered} from '../../workbench/marker/delivered-print.js';
import type {FlawActions} from './flaw-actions.js';
import {panelStyle} from './panel-style.js';
import type {Units} from '../../model/base/length-text.js';
import type {Format} from '../../texts/format.js';
import type {MarkerTexts} from '../../texts/marker-texts.js';

/** Table of the lengths that the same pieces need on fabric of other widths. */
interface Widths {
  readonly units: Units;
  readonly words: MarkerTexts;
  readonly format: Format;
  /** Note on the lengths if they do not apply to the pieces as laid. */
  readonly of: string | undefined;
  /** Lays the pieces on fabric of this width. [cm] */
  readonly take: (widthCm: number) => void;
}

function markerWidths(
  {widths, widthCm}: LayPlan,
  {units, words, format, of, take}: Widths,
): TemplateResult | typeof nothing {
  if (!widths.some(({lengthCm}) => lengthCm !== null)) return nothing;
  return html`<table class="widths">
    <caption>
      ${words.widths} ${of === undefined ? nothing : html`<span class="of">${of}</span>`}
    </caption>
    <thead>
      <tr>
        <th scope="col">${words.widthColumn}</th>
        <th scope="col" class="number">${words.lengthColumn}</th>
      </tr>
    </thead>
    <tbody>
      ${widths.map(({widthCm: width, lengthCm}) => {
        const label = format.length(width);
        return html`<tr class=${width === widthCm ? 'present' : ''}>
          <th scope="row">
            ${
              width === widthCm || lengthCm === null
                ? label
                : html`<button
                    class="link"
                    aria-label=${words.takeWidth(label)}
                    title=${words.takeWidth(label)}
                    @click=${() => {
                      take(width);
                    }}
                  >
                    ${label}
                  </button>`
            }
          </th>
          <td class="number">
            ${lengthCm === null ? words.nowhere : roundedLength(lengthCm, units, format)}
          </td>
        </tr>`;
      })}
    </tbody>
  </table>`;
}

export class MarkerPanel extends MarkerElement {
  static override properties = {
    ...MarkerElement.properties,
    selected: {attribute: false},
    conflicts: {attribute: false},
    actions: {attribute: false},
    chosenFlaw: {attribute: false},
    hasOwnWidth: {state: true},
    hasAllowances: {state: true},
    hasDelivered: {state: true},
  };
  static override styles = [controls, section, panelStyle];
  /** Number of the selected piece. */
  declare selected: number | undefined;
  /** Conflicts of pieces as messages, by piece number. */
  declare conflicts: ReadonlyMap<number, string>;
  /** Functions that change flaws, and the index of the selected flaw. */
  declare actions: FlawActions;
  declare chosenFlaw: number | undefined;
  declare protected hasOwnWidth: boolean;
  declare protected hasAllowances: boolean;
  declare protected hasDelivered: boolean;

  constructor() {
    super();
    this.conflicts = new Map();
    this.hasOwnWidth = false;
    this.hasAllowances = false;
    this.hasDelivered = false;
  }

  /** Scrolls to a piece that was selected elsewhere. */
  protected override updated(changed: PropertyValues<this>): void {
    if (!changed.has('selected')) return;
    this.renderRoot.querySelector('tr.selected')?.scrollIntoView({block: 'nearest'});
  }

  protected override render(): TemplateResult {
    const {layouts, words} = this;
    const {step, plan, state, isStale, isAwaited} = layouts;
    const isShown = plan !== undefined && state.kind !== 'failed';
    return html`<section aria-label=${words.panel} class=${isStale || isAwaited ? 'stale' : ''}>
        ${isShown ? this.#result(plan) : html`<h2>${words.panel}</h2>`} ${this.#unaligned()}
        <sw-marker-garments class="fields" .workbench=${this.workbench}></sw-marker-garments>
        ${this.#fields()} ${this.#delivered()}
      </section>
      ${
        isShown && step
          ? html`${this.#pieces(step)}
              <sw-marker-flaws
                .workbench=${this.workbench}
                .actions=${this.actions}
                .chosen=${this.chosenFlaw}
              ></sw-marker-flaws>`
          : nothing
      }
      ${isShown && step?.plan ? this.#widths(step, step.plan) : nothing}`;
  }

  /** Reason and remedies of a failed alignment, which also prevents a marker. */
  #unaligned(): TemplateResult | typeof nothing {
    const {state} = this.workbench.solving;
    if (state.kind !== 'failed') return nothing;
    return html`<sw-ways-out .workbench=${this.workbench} .failure=${state.failure}></sw-ways-out>`;
  }

  #result(plan: LayPlan): TemplateResult {
    const {words, format, layouts} = this;
    const {lengthCm, useShare, phases, placements, unplaced} = plan;
    const used = [format.length(lengthCm), format.percent(useShare)] as const;
    return html`<h2 class="buy">${this.#headline(plan)}</h2>
      <ul class="facts">
        ${
          placements.length === 0
            ? nothing
            : html`<li>${unplaced.length > 0 ? words.lying(...used) : words.used(...used)}</li>`
        }
        ${this.#isWhole(plan) ? html`${this.#cost(plan)} ${this.#proof(plan)}` : nothing}
        ${
          layouts.isMoved
            ? html`<li>${words.moved}</li>` // the rest describes the marker before the move
            : html`${this.#costs(plan)} ${this.#range(phases)} ${this.#offers(plan)}`
        }
        ${this.#notes(plan).map((note) => html`<li>${note}</li>`)}
      </ul>`;
  }

  /**
   * Returns whether all pieces can be cut as laid, so that the length of the marker can be bought.
   */
  #isWhole({unplaced}: LayPlan): boolean {
    return unplaced.length === 0 && this.conflicts.size === 0;
  }

  #cost({lengthCm}: LayPlan): TemplateResult | typeof nothing {
    const {words, format, layouts} = this;
    const {units} = this.workbench.preferences.chosen;
    const cost = costOfLength(lengthCm, layouts.choices, units, format);
    return cost === undefined ? nothing : html`<li class="cost">${words.wholeCost(cost)}</li>`;
  }

  #headline(plan: LayPlan): string {
    const {words, format, conflicts} = this;
    const {lengthCm, unplaced} = plan;
    if (unplaced.length > 0) return words.notLying(unplaced.length);
    if (conflicts.size > 0) return words.notWell(conflicts.size);
    return words.buy(soldLength(lengthCm, this.workbench.preferences.chosen.units, words, format));
  }

  #proof({proven, boundCm, unpinnedLengthCm}: LayPlan): TemplateResult | typeof nothing {
    const {words, format, layouts} = this;
    const said = unpinnedLengthCm === undefined ? words.proven : words.provenPinned;
    if (proven) return html`<li>${icon.result} ${said}</li>`;
    return layouts.state.kind === 'done' && boundCm > 0
      ? html`<li>${words.bound(format.length(boundCm))}</li>`
      : nothing;
  }

  /** Notes of the marker, except those that `#range` contains. */
  #notes({noteDetails}: LayPlan): readonly string[] {
    const {format, workbench} = this;
    const {notes} = planTextsIn(workbench.preferences.chosen.language);
    const length = (cm: number): string => format.length(cm);
    const range = (least: number, most: number) => [length(least), length(most)] as const;
    return noteDetails
      .filter((note) => !isOfPhases(note))
      .map((note) =>
        saidNote(note, notes, {
          ...{length, rounded: length, range, count: (count) => format.number(count)},
          name: (piece) => this.nameOf(piece),
        }),
      );
  }

  #costs(plan: LayPlan): TemplateResult {
    return html`${costWords(plan, this.words, this.format).map((words) => html`<li>${words}</li>`)}`;
  }

  /** Range of lengths over the possible starts of the print, if the start has not been measured. */
  #range(phases: LayPlan['phases']): readonly TemplateResult[] {
    const known = phases.flatMap(({lengthCm}) => lengthCm ?? []);
    const [least, most] = [Math.min(...known), Math.max(...known)];
    const {words, format} = this;
    const {units} = this.workbench.preferences.chosen;
    const nowhere = phases.length - known.length;
    return [
      ...(known.length > 1 && most - least >= leastCost
        ? [html`<li class="range">${lengthRange([least, most], units, words, format)}</li>`]
        : []),
      ...(known.length > 1 && nowhere > 0
        ? [html`<li class="range">${words.rangeNowhere(nowhere, phases.length)}</li>`]
        : []),
    ];
  }

  /** Changes that would take less fabric. */
  #offers({lengthCm, cheaper}: LayPlan): readonly TemplateResult[] {
    const {words, format} = this;
    return cheaper.flatMap(({kind, lengthCm: length, phaseCm = 0, pieces = [], design}) => {
      const saving = format.length(lengthCm - length);
      const names = [...new Set(pieces)].map((name) => this.nameOf(name)).join(', ');
      if (kind === 'design') return design ? [this.#designOffer(saving, design)] : [];
      const how = {phase: format.length(phaseCm), shift: names, unmatched: names};
      return [html`<li class="offer">${words.less[kind](saving, how[kind])}</li>`];
    });
  }

  /** The button applies the cheaper design as one step of the history. */
  #designOffer(saving: string, {pins, meanCm, insteadOfCm}: CheaperDesign): TemplateResult {
    const {words, format, workbench} = this;
    const [mean, instead] = [meanCm, insteadOfCm].map((cm) => format.fine(cm));
    const take = (): void => {
      const {options} = workbench.history.design ?? {};
      if (options) workbench.history.change({options: {...options, pins}});
    };
    return html`<li class="offer">
      ${words.lessDesign(saving, mean ?? '', instead ?? '')}
      <button class="link" ?disabled=${this.layouts.isStale} @click=${take}>
        ${words.takeDesign}
      </button>
    </li>`;
  }

  #fields(): TemplateResult | typeof nothing {
    const {layouts, workbench} = this;
    const {choices, plan} = layouts;
    const {design} = workbench.history;
    const preferences = workbench.preferences.chosen;
    if (!choices || !design) return nothing;
    return markerFields({
      ...{choices, units: preferences.units, format: this.format},
      ...{texts: this.texts, words: this.words, hasOwnWidth: this.hasOwnWidth},
      startCm: plan?.printOrigin?.[0],
      isOneWay: design.print.oneWay,
      hasAllowances: this.hasAllowances,
      ownAllowances: layouts.ownAllowances,
      choose: (change) => {
        if (change.widthCm !== undefined) this.hasOwnWidth = false;
        layouts.choose(change);
      },
      setPrice: (price) => {
        layouts.setPrice(price);
      },
      askOwnWidth: () => {
        this.hasOwnWidth = true;
      },
      askAllowances: () => {
        this.hasAllowances = !this.hasAllowances;
      },
    });
  }

  #delivered(): TemplateResult | typeof nothing {
    const {history, preferences} = this.workbench;
    const {print} = history.design ?? {};
    if (!print) return nothing;
    return html`<div class="fields">
      ${deliveredFields({
        ...{print, units: preferences.chosen.units, format: this.format},
        ...{texts: this.texts, words: this.words, isOpen: this.hasDelivered},
        toggle: () => {
          this.hasDelivered = !this.hasDelivered;
        },
        choose: (fabric) => {
          history.change({print: onDelivered(print, fabric)}, 'delivered fabric');
        },
      })}
    </div>`;
  }

  #pieces({pins}: LayStep): TemplateResult {
    const {layouts, words} = this;
    const {bolt, sources, pieces} = layouts;
    return html`<table class="pieces">
      <caption>
        ${words.pieces}
      </caption>
      <thead class="hidden">
        <tr>
          <th scope="col">${words.piece}</th>
          <th scope="col">${words.place}</th>
          <th scope="col">${words.pin}</th>
        </tr>
      </thead>
      <tbody>
        ${sources.map((_, number) => {
          const piece = pieces.find((one) => one.number === number);
          const label = this.labelOf({number});
          const conflict = this.conflicts.get(number);
          const place = piece && bolt ? placeWords(piece, bolt, words, this.format) : words.noPlace;
          return html`<tr
            class=${number === this.selected ? 'selected' : ''}
            aria-selected=${number === this.selected}
            tabindex="0"
            @click=${() => {
              this.#choose(number);
            }}
            @focus=${() => {
              if (number !== this.selected) this.#choose(number);
            }}
          >
            <th scope="row">${label}</th>
            <td>
              ${place}
              ${conflict === undefined ? nothing : html`<span class="error">${conflict}</span>`}
            </td>
            <td>
              <button
                class="icon"
                aria-label=${words.pinPiece(label)}
                title=${pins.has(number) ? words.unpin : words.pin}
                aria-pressed=${pins.has(number)}
                ?disabled=${!piece || layouts.isStale}
                @click=${(event: Event) => {
                  event.stopPropagation();
                  layouts.togglePin(number);
                }}
              >
                ${icon.pin}
              </button>
            </td>
          </tr>`;
        })}
      </tbody>
    </table>`;
  }

  #choose(number: number): void {
    this.dispatchEvent(new CustomEvent<number>('sw-piece-chosen', {detail: number}));
  }

  /**
   * @param plan the packed marker; its lengths stay valid while pieces are moved or off the fabric
   */
  #widths({pins}: LayStep, plan: LayPlan): TemplateResult | typeof nothing {
    const {layouts, words, format} = this;
    const {packed, unpinned} = words.widthsOf;
    const isPinned = pins.size > 0 || plan.unpinnedLengthCm !== undefined;
    return markerWidths(plan, {
      ...{units: this.workbench.preferences.chosen.units, words, format},
      of: isPinned ? unpinned : layouts.isMoved ? packed : undefined,
      take: (widthCm) => {
        layouts.choose({widthCm});
      },
    });
  }
}
