/** A photo with its settings beside it. */
import {css, html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import type {Point} from '../../model/geometry/vectors.js';
import type {KnownObject, PhotoMap} from '../../model/print/photo-reading.js';
import {controls} from '../style/controls.js';
import type {BrokenPlaces} from '../../photo/breaks-on-photo.js';
import type {PhotoSize} from '../../photo/lattice-lines.js';
import {drawnByHand, PhotoElement, photoProgress, progressStyle} from './photo-element.js';
import type {Measuring} from './photo-measures.js';
import type {Moved, Placed, TwoPoints} from './photo-stage.js';
import {arrowNames, type ArrowNames} from '../../photo/arrow-names.js';
import {groupIn, groupOf, isStriped, type PhotoStep} from '../../photo/photo-step.js';
import type {PhotoTexts} from '../../texts/photo-texts.js';
import type {Overlays, Vector} from './stage-marks.js';

const workStyle = css`
  :host {
    display: grid;
    grid-template-columns: minmax(0, 1fr) 22rem;
    min-height: 0;
  }
  sw-photo-stage {
    padding: var(--sw-space-3);
    background: var(--sw-ground);
    --stage-height: calc(100dvh - 11rem);
  }
  .side {
    display: grid;
    align-content: start;
    gap: var(--sw-space-3);
    padding: var(--sw-space-4);
    overflow-y: auto;
    border-left: 1px solid var(--sw-line);
  }
  @media (width < 48rem) {
    :host {
      grid-template-columns: minmax(0, 1fr);
      grid-template-rows: auto minmax(0, 1fr);
    }
    sw-photo-stage {
      padding: 0;
      --stage-height: 38dvh;
    }
    .side {
      border-left: 0;
      border-top: 1px solid var(--sw-line);
    }
  }
`;

/** Fires `hand` with the `PhotoMap` that the user draws, or without detail at its end. */
export class PhotoWork extends PhotoElement {
  static override properties = {
    ...PhotoElement.properties,
    picture: {},
    natural: {attribute: false},
    hand: {attribute: false},
    overlays: {state: true},
    way: {state: true},
    points: {state: true},
    along: {state: true},
    objectAt: {state: true},
    whiteAt: {state: true},
    object: {state: true},
    broken: {state: true},
  };
  static override styles = [controls, workStyle, progressStyle];
  /** URL of the photo. */
  declare picture: string;
  /** Size of the photo as the browser shows it. */
  declare natural: PhotoSize;
  /** Lattice drawn by the user. */
  declare hand: PhotoMap | undefined;
  declare protected overlays: Overlays;
  declare protected way: Measuring;
  /** Ends of the distance to measure. */
  declare protected points: TwoPoints | undefined;
  /** Vector along which a tape measures. */
  declare protected along: Vector | undefined;
  /** Coin or card on the fabric, and its approximate place. */
  declare protected object: KnownObject;
  declare protected objectAt: Point | undefined;
  /** White spot, while the user chooses it. */
  declare protected whiteAt: Point | undefined;
  /** Places at which the print breaks the chosen symmetry. */
  declare protected broken: BrokenPlaces | undefined;
  #seen: PhotoStep | undefined;

  constructor() {
    super();
    this.overlays = {cells: true, axes: false, differing: true, breaks: true};
    this.object = 'eur1';
    this.way = 'tape';
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const {step} = this.session.read;
    if (changed.has('session')) {
      this.way = 'tape';
      this.points = undefined;
      this.objectAt = undefined;
      this.whiteAt = undefined;
      this.broken = undefined;
      this.#seen = undefined;
    }
    if (step && step !== this.#seen) this.#follow(step, this.#seen);
    this.#seen = step;
  }

  protected override render(): TemplateResult {
    const {words, hand, way, whiteAt, session} = this;
    const {step, state} = session.read;
    const size = step?.reading ?? this.natural;
    const map = hand ?? (step && groupIn(step).map);
    return html`<sw-photo-stage
        .picture=${this.picture}
        .size=${size}
        .map=${map}
        .group=${step && !hand ? groupOf(step) : undefined}
        .differing=${step?.reading.differing ?? []}
        .broken=${hand ? undefined : this.broken}
        .outline=${way === 'object' ? step?.object?.outline : undefined}
        .overlays=${this.overlays}
        .points=${way === 'points' ? this.points : undefined}
        .measured=${way === 'tape' ? this.along : undefined}
        .names=${map && namesOf(map, size, words, !hand && step && isStriped(step))}
        .aim=${whiteAt ?? (way === 'object' ? this.objectAt : undefined)}
        .aimLabel=${whiteAt ? words.aimWhite : words.aim}
        .words=${words}
        .isBusy=${state.kind === 'reading'}
        @moved=${({detail}: CustomEvent<Moved>) => {
          if (hand) this.#draw(detail.map);
          else void session.align(detail.map, detail.keeps);
        }}
        @measured=${({detail}: CustomEvent<Placed<TwoPoints>>) => {
          this.#measured(detail);
        }}
        @aimed=${({detail}: CustomEvent<Placed<Point>>) => {
          this.#aimed(detail);
        }}
      ></sw-photo-stage>
      <div class="side">
        ${hand ? this.#drawn(hand) : photoProgress(session, this.said)}
        ${hand ? nothing : this.#panel(size)}
      </div>`;
  }

  #draw(detail: PhotoMap | undefined): void {
    this.dispatchEvent(new CustomEvent('hand', {detail}));
  }

  #panel(size: PhotoSize): TemplateResult {
    const {session} = this;
    return html`<sw-photo-panel
      .workbench=${this.workbench}
      .session=${session}
      .overlays=${this.overlays}
      .isWhitening=${this.whiteAt !== undefined}
      @overlays=${({detail}: CustomEvent<Overlays>) => {
        this.overlays = detail;
      }}
      @broken=${({detail}: CustomEvent<BrokenPlaces | null>) => {
        this.broken = detail ?? undefined;
      }}
      @whiten=${() => {
        this.whiteAt = this.whiteAt ? undefined : middleOf(size);
      }}
    >
      <sw-photo-measures
        .workbench=${this.workbench}
        .session=${session}
        .way=${this.way}
        .points=${this.points}
        .object=${this.object}
        @along=${({detail}: CustomEvent<Vector | null>) => {
          this.along = detail ?? undefined;
        }}
        @measuring=${({detail}: CustomEvent<Measuring>) => {
          this.way = detail;
          this.points ??= startPoints(size);
          this.objectAt ??= middleOf(size);
        }}
        @object=${({detail}: CustomEvent<KnownObject>) => {
          this.object = detail;
          const {objectAt} = this;
          if (session.step?.object && objectAt) void session.measureBy(detail, objectAt);
        }}
        @look=${() => {
          if (this.objectAt) void session.measureBy(this.object, this.objectAt);
        }}
      ></sw-photo-measures>
    </sw-photo-panel>`;
  }

  #drawn(hand: PhotoMap): TemplateResult {
    const leave = (): void => {
      this.#draw(undefined);
    };
    return drawnByHand(this.said, {
      leave,
      align: () => {
        leave();
        void this.session.align(hand);
      },
    });
  }

  #measured({at, isSettled}: Placed<TwoPoints>): void {
    const {session} = this;
    this.points = at;
    const [from, to] = at;
    const between = session.step?.between;
    if (isSettled && between) session.measureBetween({...between, from, to});
  }

  #aimed({at, isSettled}: Placed<Point>): void {
    const {session} = this;
    if (this.whiteAt) {
      this.whiteAt = isSettled ? undefined : at;
      if (isSettled) void session.whiten(at);
    } else {
      this.objectAt = at;
      if (isSettled) void session.measureBy(this.object, at);
    }
  }

  /** Shows the kind of measurement that a step changed, also after undo and redo. */
  #follow(step: PhotoStep, before: PhotoStep | undefined): void {
    const {between, object, w1Measured, w2Measured} = step;
    if (between && between !== before?.between) {
      this.way = 'points';
      this.points = [between.from, between.to];
    } else if (object && object !== before?.object) {
      this.way = 'object';
      this.object = object.object;
      this.objectAt = centreOf(object.outline);
    } else if (
      (w1Measured && w1Measured !== before?.w1Measured) ||
      (w2Measured && w2Measured !== before?.w2Measured)
    ) {
      this.way = 'tape';
    }
  }
}

/** Names of the arrows; that of stripes needs none. */
function namesOf(
  map: PhotoMap,
  size: PhotoSize,
  {ways}: PhotoTexts,
  isStriped = false,
): ArrowNames {
  return isStriped ? {w1: ''} : arrowNames(map, size, ways);
}

/** Initial points around the middle, to be dragged. */
const startPoints = ({width, height}: PhotoSize): TwoPoints => [
  [0.25 * width, 0.5 * height],
  [0.75 * width, 0.5 * height],
];

const middleOf = ({width, height}: PhotoSize): Point => [width / 2, height / 2];

function centreOf(outline: readonly Point[]): Point {
  const sum = outline.reduce<Point>(([x, y], [px, py]) => [x + px, y + py], [0, 0]);
  return [sum[0] / outline.length, sum[1] / outline.length];
}
