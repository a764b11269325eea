/** Fields for the size of the repeat on the fabric, and for its angle. */
import {css, html, nothing, svg, type PropertyValues, type TemplateResult} from 'lit';

import {combined, norm, radians, towards, type Point} from '../../model/geometry/vectors.js';
import {noPicture, type DesignPrint} from '../../model/design/design.js';
import {
  fittingGroup,
  isCoupled,
  latticeVectors,
  leastRepeat,
  mostRepeat,
  type FittingGroup,
  type RepeatSize,
} from '../../model/print/repeat.js';
import {cellSize, cellTurn, resized, tileSize, tileTurn} from '../../model/design/tile-repeat.js';
import {latticeType} from '../../model/print/wallpaper.js';
import {lengthUnit} from '../controls/number-field.js';
import {directionSign} from '../../texts/direction-sign.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {choiceOf} from '../../print/group-choice.js';
import {takePrint} from '../../workbench/print/take-print.js';

/** Diagram of a print's cell on the fabric, with its two measured sides. */
interface CellDiagram {
  readonly size: RepeatSize;
  /** Counter-clockwise. [degrees] */
  readonly turnDeg: number;
  readonly names: {readonly width: string; readonly height: string};
  readonly label: string;
}

/** Size of the drawing. [px] */
const [wide, tall] = [260, 104];
/** Longest side of the box around the cell, and distance of names from it. [px] */
const room = 62;
const away = 9;

function cellDiagram({size, turnDeg, names, label}: CellDiagram): TemplateResult {
  // any two sides at any angle form an oblique cell
  const [a, b] = latticeVectors('p1', size, turnDeg);
  const reach = (k: 0 | 1): number => Math.abs(a[k]) + Math.abs(b[k]);
  const scale = Math.min((1.8 * room) / reach(0), room / reach(1));
  const at = (s: number, t: number): Point => {
    const [x, y] = combined([a, b], s - 1 / 2, t - 1 / 2);
    return [wide / 2 + scale * x, tall / 2 - scale * y];
  };
  const line = (...points: readonly Point[]): string =>
    `M${points.map((p) => p.join(' ')).join('L')}`;
  const named = (name: string, [x, y]: Point): TemplateResult => {
    const [outX, outY] = [x - wide / 2, y - tall / 2];
    const length = norm([outX, outY]) || 1;
    const anchor = Math.abs(outX) < 0.5 * length ? 'middle' : outX > 0 ? 'start' : 'end';
    return svg`<text
      x=${x + (away * outX) / length}
      y=${y + (away * outY) / length + 4}
      text-anchor=${anchor}
    >${name}</text>`;
  };
  return html`<svg class="cell" viewBox="0 0 ${wide} ${tall}" role="img" aria-label=${label}>
    ${svg`<path class="inside" d="${line(at(0, 0), at(1, 0), at(1, 1), at(0, 1))}z"></path>
      <path class="side" d=${line(at(0, 0), at(1, 0))}></path>
      <path class="side up" d=${line(at(0, 0), at(0, 1))}></path>
      ${named(names.width, at(0.5, 0))} ${named(names.height, at(0, 0.5))}
      <path class="warp" d="M${wide - 12} 88V18m-4 6 4-7 4 7"></path>`}
  </svg>`;
}

const cellDiagramStyle = css`
  .cell {
    width: 100%;
    max-width: 18rem;
  }
  .cell path {
    fill: none;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .cell .inside {
    fill: var(--sw-tint);
    stroke: var(--sw-line);
  }
  .cell .side {
    stroke: var(--sw-accent);
    stroke-width: 3;
  }
  .cell .up {
    stroke-dasharray: 1 5;
  }
  .cell .warp {
    stroke: var(--sw-soft);
    stroke-width: 1.2;
  }
  .cell text {
    font-size: 12px;
    fill: var(--sw-ink);
  }
`;

/** Returns the arrow of a side on the fabric, unless its direction is the usual one. */
function signOfLying(direction: Point, usual: string): string {
  const sign = directionSign(direction);
  return usual.includes(sign) ? '' : sign;
}

export class RepeatFields extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    measured: {state: true},
    isFree: {state: true},
  };
  /** A measured cell that the print's group does not allow. */
  declare protected measured: {readonly of: DesignPrint; readonly size: RepeatSize} | undefined;
  /** The image whose width and height the user enters separately. */
  declare protected isFree: string | undefined;

  static override styles = [
    controls,
    cellDiagramStyle,
    css`
      :host {
        display: grid;
        gap: var(--sw-space-3);
      }
      .sides {
        display: grid;
        grid-template-columns: minmax(0, 1fr) auto minmax(0, 1fr);
        gap: var(--sw-space-1);
        align-items: end;
      }
      .angles {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: var(--sw-space-2);
      }
      .cell {
        justify-self: center;
      }
      .sides:has(> .width:focus-within) ~ .cell .side:not(.up),
      .sides:has(> .height:focus-within) ~ .cell .up {
        stroke: var(--sw-bad);
        stroke-width: 5;
      }
      .offer {
        display: grid;
        gap: var(--sw-space-2);
        padding: var(--sw-space-3);
        border-radius: var(--sw-radius);
        background: var(--sw-tint);
      }
      .offer div {
        display: flex;
        gap: var(--sw-space-2);
      }
      sw-measure:not(:defined) {
        height: var(--sw-target); /* of its button */
      }
      .question p {
        margin-left: calc(1rem + var(--sw-space-2));
      }
    `,
  ];

  override focus(): void {
    this.renderRoot.querySelector<HTMLElement>('sw-number-field')?.focus();
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const print = this.workbench.history.design?.print;
    if (this.measured && this.measured.of !== print) this.measured = undefined;
    if (this.isFree !== print?.image) this.isFree = undefined;
  }

  protected override render(): TemplateResult | typeof nothing {
    const print = this.workbench.history.design?.print;
    if (!print) return nothing;
    const texts = this.texts.print;
    const {workbench} = this;
    return html`
      ${this.#sides(print)} ${this.#offer(print)}
      <sw-measure .workbench=${workbench}></sw-measure>
      ${
        print.sample || print.image === noPicture
          ? nothing
          : html`<sw-file-size .workbench=${workbench}></sw-file-size>`
      }
      ${this.#lie(print)}
      <div class="question">
        <label class="inline">
          <input
            type="checkbox"
            aria-describedby="upside-down"
            .checked=${print.oneWay}
            @change=${(event: Event) => {
              const {checked} = event.target as HTMLInputElement;
              workbench.history.change({print: {...print, oneWay: checked}});
            }}
          />
          ${texts.oneWay}
        </label>
        <p id="upside-down" class="soft">${texts.oneWayNote}</p>
      </div>
    `;
  }

  /** Fields for width and height; stripes need no height, since any is valid along them. */
  #sides(print: DesignPrint): TemplateResult {
    const texts = this.texts.print;
    const size = tileSize(print);
    const turn = radians(tileTurn(print));
    const width = (enter: (cm: number) => void): TemplateResult =>
      this.#length('width', signOfLying(towards(turn), '→←'), size.width, enter);
    if (choiceOf(print) === 'stripes') {
      return width((cm) => {
        this.#resize(print, {...size, width: cm});
      });
    }
    const isLocked = this.isFree === undefined;
    const shownHeight = this.measured ? tileSize({...print, ...this.measured}).height : size.height;
    return html`<div class="sides">
      ${width((cm) => {
        const height = isLocked ? (size.height * cm) / size.width : size.height;
        this.#resize(print, {...size, width: cm, height});
      })}
      <button
        class="icon"
        aria-pressed=${isLocked}
        aria-label=${texts.proportions}
        title=${texts.proportions}
        @click=${() => {
          this.isFree = isLocked ? print.image : undefined;
          this.measured = undefined;
        }}
      >
        ${isLocked ? icon.locked : icon.unlocked}
      </button>
      ${this.#length(
        'height',
        signOfLying(towards(turn + radians(size.angleDeg)), '↑↓'),
        shownHeight,
        (cm) => {
          const free = {...size, height: cm};
          if (isLocked) this.#resize(print, {...free, width: (size.width * cm) / size.height});
          else if (isCoupled(print.group)) this.measured = {of: print, size: cellSize(print, free)};
          else this.#resize(print, free);
        },
      )}
    </div>`;
  }

  /** Fields for the angles, and a drawing of angles and sides. */
  #lie(print: DesignPrint): TemplateResult {
    const {print: texts} = this.texts;
    const size = tileSize(print);
    const turn = tileTurn(print);
    const {format} = this;
    // cells are often not rectangular, images rarely
    const isSlanted = latticeType(print.group) === 'oblique' && print.cell === 'primitive';
    const asksAngle = isSlanted && (size.angleDeg !== 90 || this.isFree !== undefined);
    const angle = `${format.number(turn)}°`;
    return html`<div class="angles">
        ${
          asksAngle
            ? this.#degrees(texts.angle, size.angleDeg, 20, 160, (angleDeg) => {
                this.#resize(print, {...size, angleDeg});
              })
            : nothing
        }
        ${this.#degrees(texts.turn, turn, -180, 180, (degrees) => {
          this.workbench.history.change(
            {print: {...print, turnDeg: cellTurn(print, degrees)}},
            'print size',
          );
        })}
      </div>
      ${cellDiagram({
        ...{size, turnDeg: turn, names: texts.sideNames},
        label: texts.sides(format.length(size.width), format.length(size.height), angle),
      })}`;
  }

  #length(
    side: 'width' | 'height',
    sign: string,
    value: number,
    enter: (cm: number) => void,
  ): TemplateResult {
    const {name, cm} = lengthUnit[this.workbench.preferences.chosen.units];
    const {format} = this;
    return html`<sw-number-field
      class=${side}
      .label=${this.texts.print[side](name)}
      .sign=${sign}
      .value=${this.workbench.history.design?.print.unscaled ? NaN : value / cm}
      .subject=${this.workbench.history.design?.print.image}
      .least=${leastRepeat / cm}
      .most=${mostRepeat / cm}
      .step=${0.1}
      .fractions=${this.workbench.preferences.chosen.units === 'inch'}
      .wrong=${this.texts.controls.between(format.length(leastRepeat), format.length(mostRepeat))}
      @entered=${({detail}: CustomEvent<number>) => {
        enter(detail * cm);
      }}
    ></sw-number-field>`;
  }

  #degrees(
    label: string,
    value: number,
    least: number,
    most: number,
    enter: (degrees: number) => void,
  ): TemplateResult {
    return html`<sw-number-field
      .label=${label}
      .value=${value}
      .subject=${this.workbench.history.design?.print.image}
      .least=${least}
      .most=${most}
      .wrong=${this.texts.controls.between(`${least}°`, `${most}°`)}
      @entered=${({detail}: CustomEvent<number>) => {
        enter(detail);
      }}
    ></sw-number-field>`;
  }

  /** Offers a group that fits a measured cell. */
  #offer(print: DesignPrint): TemplateResult | typeof nothing {
    const fitting = this.measured && fittingGroup(print.group, this.measured.size);
    // otherwise, another cell of the image would have to be drawn
    const drawn = latticeType(print.group) === 'square' || print.cell === 'rectangular';
    if (!fitting || !drawn) return nothing;
    const texts = this.texts.print;
    return html`<div class="offer" role="status">
      <p>${texts.notQuite(texts.kinds[print.group], texts.kinds[fitting.group])}</p>
      <div>
        <button class="outlined" @click=${() => this.#take(print, fitting)}>
          ${texts.take(texts.kinds[fitting.group])}
        </button>
        <button
          @click=${() => {
            this.measured = undefined;
          }}
        >
          ${texts.keep(texts.kinds[print.group])}
        </button>
      </div>
    </div>`;
  }

  #resize(print: DesignPrint, size: RepeatSize): void {
    this.workbench.history.change({print: resized(print, size)}, 'print size');
  }

  async #take(print: DesignPrint, fitting: FittingGroup): Promise<void> {
    const {withGroup} = await import('../../print/own-print.js');
    const smaller = await withGroup(print, fitting);
    if (this.workbench.history.design?.print === print) takePrint(this.workbench, smaller);
  }
}
