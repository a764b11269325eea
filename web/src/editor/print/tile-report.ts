/**
 * Report on the user's own image: the places that break the symmetries of its group, and remedies.
 */
import {css, html, nothing, type TemplateResult} from 'lit';

import {noPicture, type DesignPrint} from '../../model/design/design.js';
import {pictureIn} from '../../model/design/tile-repeat.js';
import type {TileRepeat} from '../../model/print/opened-image.js';
import type {Asymmetry} from '../../image/asymmetry.js';
import type {TileCheck} from '../../image/tile-check.js';
import type {OpenEdge} from '../../model/print/photo-reading.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {choiceOf, meaningOf} from '../../print/group-choice.js';
import {takePrint} from '../../workbench/print/take-print.js';
import {edgesPath, markedTile, markedTileStyle, outlineOf} from './marked-tile.js';
import {
  closedRepeats,
  openEdgesOf,
  openPairs,
  type FoundGroup,
  type ReadsPictures,
} from '../../print/own-groups.js';
import {
  checked,
  groupsOfOwn,
  pixelsOfTile,
  printOfPicture,
  withFound,
} from '../../print/own-print.js';
import type {Texts} from '../../texts/en.js';

/** Buttons for the repeats that make an image seamless. */
export const remedies = (
  {remedy, repeats: names}: Texts['print'],
  repeats: readonly TileRepeat[],
  take: (repeat: TileRepeat) => unknown,
): readonly TemplateResult[] =>
  repeats.map((repeat) => {
    const words = repeat === 'halfDrop' || repeat === 'brick' ? remedy[repeat] : remedy.mirror;
    return html`<button class="outlined" title=${names[repeat]} @click=${() => take(repeat)}>
      ${words}
    </button>`;
  });

interface Report {
  readonly print: DesignPrint;
  readonly check: TileCheck;
  readonly lacks: readonly Asymmetry[];
  readonly isStriped: boolean;
  readonly groups: readonly FoundGroup[];
  readonly edges: readonly OpenEdge[];
  /** Repeats that would make it seamless. */
  readonly repeats: readonly TileRepeat[];
}

async function reportOf(solver: ReadsPictures, print: DesignPrint): Promise<Report> {
  const own = pictureIn(print);
  const [{asymmetriesOf, isStriped}, check, groups, pixels, edges, repeats] = await Promise.all([
    import('../../image/asymmetry.js'),
    checked(print),
    groupsOfOwn(solver, own),
    pixelsOfTile(own),
    openEdgesOf(solver, own),
    closedRepeats(solver, own.image),
  ]);
  const turn = 90 * Math.round(print.turnDeg / 90);
  const striped = isStriped(pixels) || choiceOf(print) === 'stripes';
  const lacks = asymmetriesOf(check, print.group, turn);
  return {print, check, lacks, groups, edges, repeats, isStriped: striped};
}

export class TileReport extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, report: {state: true}};
  declare protected report: Report | undefined;
  #looked: DesignPrint | undefined;

  static override styles = [
    controls,
    markedTileStyle,
    css`
      :host {
        display: grid;
        gap: var(--sw-space-2);
      }
      small {
        font-size: var(--sw-text);
        color: var(--sw-soft);
      }
    `,
  ];

  protected override updated(): void {
    const print = this.workbench.history.design?.print;
    if (!print || print === this.#looked) return;
    this.#looked = print;
    if (print.image === noPicture) return;
    this.#look(print).catch(() => undefined); // the pattern shows this failure
  }

  protected override render(): TemplateResult | typeof nothing {
    const print = this.workbench.history.design?.print;
    if (!print) return nothing;
    const texts = this.texts.print;
    if (print.image === noPicture) return html`<p role="status">${texts.needsPicture}</p>`;
    const {report} = this;
    if (report?.print !== print) return nothing;
    return html`${this.#edges(report)}
    ${
      report.check.breaks.length > 0
        ? this.#breaks(report)
        : html`<p role="status" class="soft">${texts.keeps} ${texts.meanings[meaningOf(print)]}</p>`
    }`;
  }

  #edges({print, edges, repeats}: Report): TemplateResult | typeof nothing {
    if (edges.length === 0) return nothing;
    const texts = this.texts.print;
    const own = pictureIn(print);
    return html`<div class="breaks" role="status">
      ${markedTile({
        ...{image: own.image, size: own.size, turnDeg: 0, marks: edgesPath(edges)},
        label: texts.marked(print.title),
      })}
      <div>
        <p>${texts.openEdges[openPairs(edges)]}</p>
        ${
          print.file
            ? nothing
            : html`<div class="row">
                ${remedies(texts, repeats, (repeat) => this.#repeat(print, repeat))}
              </div>`
        }
      </div>
    </div>`;
  }

  #breaks({print, check, lacks, isStriped, groups}: Report): TemplateResult {
    const texts = this.texts.print;
    const {language} = this.workbench.preferences.chosen;
    const hows = new Intl.ListFormat(language, {type: 'conjunction'});
    // the repeat along a stripe may be too short to show anything
    const shape = choiceOf(print) === 'stripes' ? {width: 3, height: 2} : print.size;
    const how = hows.format(lacks.slice(0, 3).map((one) => texts.differs[one]));
    return html`<div class="breaks" role="status">
      ${markedTile({
        ...{image: print.image, size: shape, marks: outlineOf(check.breaks)},
        ...{label: texts.marked(print.title), turnDeg: print.tile?.turnedDeg ?? 0},
      })}
      <div>
        <p>${texts.reads[isStriped ? 'stripes' : 'picture'](how)}</p>
        <p>${texts.has}</p>
        <div class="row">${groups.map((found) => this.#found(print, found))}</div>
      </div>
    </div>`;
  }

  #found(print: DesignPrint, found: FoundGroup): TemplateResult {
    return html`<button
      class="outlined"
      @click=${() => this.#take(print, withFound(this.workbench.solver, print, found))}
    >
      ${this.texts.print.meanings[found.group]}
    </button>`;
  }

  async #look(print: DesignPrint): Promise<void> {
    const report = await reportOf(this.workbench.solver, print);
    if (this.#looked === print) this.report = report;
  }

  #repeat(print: DesignPrint, repeat: TileRepeat): Promise<void> {
    return this.#take(print, printOfPicture(this.workbench.solver, {...pictureIn(print), repeat}));
  }

  async #take(print: DesignPrint, taken: Promise<DesignPrint>): Promise<void> {
    const next = await taken;
    if (this.workbench.history.design?.print === print) takePrint(this.workbench, next);
  }
}
