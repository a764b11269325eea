/** The sheet on which a photograph of cloth becomes a print. */
import {html, nothing, type TemplateResult} from 'lit';

import type {Failure} from '../../model/failure.js';
import {photoFaults, type PhotoMap} from '../../model/photo.js';
import {dataUrlOf} from '../../recognition/data-url.js';
import {photoTexts, type PhotoTexts} from '../../texts/photo-texts.js';
import {toFailure} from '../../workbench/latest-solve.js';
import {focused} from '../base/focused.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import type {PhotoOfCloth} from '../print/print-files.js';
import {kindOf} from '../print/read-picture.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {sheetDialog} from '../style/sheet-dialog.js';
import {dialogStyle} from './dialog-style.js';
import type {PhotoKeeper} from './photo-keeper.js';
import type {PhotoSize} from './lattice-lines.js';
import {cellPicture, pngOf} from '../print/photo-picture.js';
import {PhotoSession} from './photo-session.js';
import type {Moved, Overlays, TwoPoints} from './photo-stage.js';
import {groupIn, groupOf, measuresOf, type PhotoStep} from '../print/photo-step.js';

/** Kinds that browsers decode; of others it is said what they are. */
const decodable: ReadonlySet<string> = new Set(['png', 'jpeg', 'webp', 'avif', 'gif', 'bmp']);

export class PhotoDialog extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    session: {state: true},
    size: {state: true},
    overlays: {state: true},
    points: {state: true},
    hand: {state: true},
    name: {state: true},
    trouble: {state: true},
    isTaking: {state: true},
  };
  static override styles = [controls, sheetDialog, dialogStyle];
  /** Undefined until there is a picture. */
  declare protected session: PhotoSession | undefined;
  /** Of the picture as the browser shows it. */
  declare protected size: PhotoSize | undefined;
  declare protected overlays: Overlays;
  /** Whose distance is to be measured. */
  declare protected points: TwoPoints | undefined;
  /** A lattice that somebody draws. */
  declare protected hand: PhotoMap | undefined;
  declare protected name: string;
  /** What went wrong with the picture, or with taking it. */
  declare protected trouble: string | undefined;
  declare protected isTaking: boolean;
  keeper: PhotoKeeper | undefined;
  #address: string | undefined;
  /** The focus went to what takes the print, once. */
  #isLed = false;

  constructor() {
    super();
    this.overlays = {cells: true, axes: false, differing: true};
    this.name = '';
    this.isTaking = false;
  }

  async open(given?: PhotoOfCloth): Promise<void> {
    await this.updateComplete;
    const dialog = this.renderRoot.querySelector('dialog');
    if (!dialog?.open) dialog?.showModal();
    if (given) await this.#take(given.picture, given.name);
    else if (!this.session) await this.#again();
  }

  /** What was read may be taken without a closer look. */
  get #isSure(): boolean {
    const {state, step} = this.session ?? {};
    return state?.kind === 'done' && step?.reading.confidence !== 'uncertain';
  }

  protected get words(): PhotoTexts {
    const {language, messages} = this.workbench.preferences;
    return photoTexts(language, messages);
  }

  protected override updated(): void {
    if (this.#isLed || !this.#isSure) return;
    this.#isLed = true;
    const at = focused();
    const isLost =
      !at || at === document.body || at.localName === 'dialog' || !!at.closest('header');
    if (isLost) this.renderRoot.querySelector<HTMLElement>('footer .primary')?.focus();
  }

  protected override render(): TemplateResult {
    const {words, texts, session} = this;
    return html`<dialog
      aria-labelledby="title"
      @close=${this.#ended}
      @keydown=${this.#key}
      @dragover=${(event: DragEvent) => {
        if (!event.dataTransfer?.types.includes('Files')) return;
        event.preventDefault();
        event.stopPropagation();
      }}
      @drop=${(event: DragEvent) => {
        this.#hand(event, event.dataTransfer?.files[0]);
      }}
      @paste=${(event: ClipboardEvent) => {
        this.#hand(event, event.clipboardData?.files[0]);
      }}
    >
      <header>
        <h2 id="title">${words.title}</h2>
        ${session ? this.#travel(session) : nothing}
        <button
          class="icon"
          aria-label=${texts.app.close}
          title=${texts.app.close}
          @click=${this.#close}
        >
          ${icon.close}
        </button>
      </header>
      ${session && this.size ? this.#work(session, this.size) : this.#intake()}
    </dialog>`;
  }

  #travel(session: PhotoSession): TemplateResult {
    const {app} = this.texts;
    const {canUndo, canRedo} = session.read;
    return html`<button
        class="icon"
        aria-label=${app.undo}
        title=${app.undo}
        ?disabled=${!canUndo}
        @click=${() => session.undo()}
      >
        ${icon.undo}
      </button>
      <button
        class="icon"
        aria-label=${app.redo}
        title=${app.redo}
        ?disabled=${!canRedo}
        @click=${() => session.redo()}
      >
        ${icon.redo}
      </button>`;
  }

  #intake(): TemplateResult {
    const {words} = this;
    return html`<div class="intake">
      <p>${words.intake}</p>
      <p class="soft">${words.stays}</p>
      ${this.trouble ? html`<p class="error" role="alert">${this.trouble}</p>` : nothing}
      <div class="row">
        ${this.#file(words.choose, false, 'primary')} ${this.#file(words.camera, true, 'outlined')}
      </div>
    </div>`;
  }

  /** A button that asks for a picture; on phones, `camera` takes one. */
  #file(label: string, isCamera: boolean, look: string): TemplateResult {
    return html`<span class=${isCamera ? 'camera' : ''}>
      <input
        type="file"
        hidden
        accept="image/*"
        capture=${isCamera ? 'environment' : nothing}
        @change=${(event: Event) => {
          const input = event.target as HTMLInputElement;
          const [file] = input.files ?? [];
          if (file) void this.#take(file, file.name);
          input.value = '';
        }}
      />
      <button
        class=${look}
        @click=${(event: Event) => {
          const {parentElement} = event.currentTarget as HTMLElement;
          parentElement?.querySelector('input')?.click();
        }}
      >
        ${label}
      </button>
    </span>`;
  }

  #work(session: PhotoSession, natural: PhotoSize): TemplateResult {
    const {words, hand, points} = this;
    const {step, state} = session.read;
    const size = step?.reading ?? natural;
    const map = hand ?? (step && groupIn(step).map);
    return html`<div class="body">
        <sw-photo-stage
          .picture=${this.#address ?? ''}
          .size=${size}
          .map=${map}
          .group=${step && !hand ? groupOf(step) : undefined}
          .differing=${step?.reading.differing ?? []}
          .overlays=${this.overlays}
          .points=${points}
          .words=${words}
          .isBusy=${state.kind === 'reading'}
          @moved=${({detail}: CustomEvent<Moved>) => {
            if (hand) this.hand = detail.map;
            else void session.align(detail.map, detail.keeps);
          }}
          @measured=${({detail}: CustomEvent<TwoPoints>) => {
            this.points = detail;
            const between = session.step?.between;
            const [from, to] = detail;
            if (between) session.change({between: {...between, from, to}});
          }}
        ></sw-photo-stage>
        <div class="side">
          ${this.#state(session)}
          ${
            hand
              ? nothing
              : html`<sw-photo-panel
                  .workbench=${this.workbench}
                  .session=${session}
                  .overlays=${this.overlays}
                  .points=${points}
                  @overlays=${({detail}: CustomEvent<Overlays>) => {
                    this.overlays = detail;
                  }}
                  @ruler=${({detail}: CustomEvent<boolean>) => {
                    this.points = detail ? startPoints(size) : undefined;
                  }}
                ></sw-photo-panel>`
          }
        </div>
      </div>
      ${this.#foot(session, size)}`;
  }

  #state(session: PhotoSession): TemplateResult | typeof nothing {
    const {words, format, hand} = this;
    const {state} = session;
    if (hand) {
      return html`<div class="note" role="status">
        <p>${words.hand}</p>
        <button
          class="primary"
          @click=${() => {
            this.hand = undefined;
            void session.align(hand);
          }}
        >
          ${words.alignHand}
        </button>
        <button
          class="outlined"
          @click=${() => {
            this.hand = undefined;
          }}
        >
          ${this.texts.app.cancel}
        </button>
      </div>`;
    }
    switch (state.kind) {
      case 'reading':
        return html`<div class="note" role="status">
          <p>${words.reading(words.stages[state.stage], format.percent(state.fraction))}</p>
          <progress
            max="1"
            .value=${state.fraction}
            aria-label=${words.stages[state.stage]}
          ></progress>
          <button
            class="outlined"
            @click=${() => {
              session.cancel();
            }}
          >
            ${this.texts.app.cancel}
          </button>
        </div>`;
      case 'cancelled':
        return html`<div class="note" role="status">
          <p>${words.cancelled}</p>
          <button class="outlined" @click=${() => void session.begin()}>${words.again}</button>
        </div>`;
      case 'failed':
        return html`<p class="error" role="alert">${this.#said(state.failure)}</p>`;
      case 'done':
        return nothing;
    }
  }

  #said({code, reason, message}: Failure): string {
    if (code === 'not-an-image' && this.trouble) return this.trouble;
    const fault = photoFaults.find((known) => known === reason);
    return fault ? this.words.faults[fault] : message;
  }

  #foot(session: PhotoSession, size: PhotoSize): TemplateResult {
    const {words, hand} = this;
    const {step, state} = session;
    const isReady = step !== undefined && !hand && state.kind !== 'reading';
    return html`<footer>
      ${
        this.trouble && state.kind !== 'failed'
          ? html`<p class="error" role="alert">${this.trouble}</p>`
          : nothing
      }
      <label class="name">
        ${words.name}
        <input
          type="text"
          maxlength="80"
          .value=${this.name}
          @change=${(event: Event) => {
            this.name = (event.target as HTMLInputElement).value;
          }}
        />
      </label>
      ${this.#file(words.another, false, 'outlined')}
      <button
        class="outlined"
        ?disabled=${hand !== undefined || state.kind === 'reading'}
        @click=${() => {
          this.hand = startLattice(size);
        }}
      >
        ${words.byHand}
      </button>
      <button
        class="primary"
        ?disabled=${!isReady || this.isTaking}
        @click=${() => void this.#use(session)}
      >
        ${words.use}
      </button>
    </footer>`;
  }

  #hand(event: Event, file: File | undefined): void {
    event.stopPropagation(); // the page takes files, too
    if (!file) return;
    event.preventDefault();
    void this.#take(file, file.name);
  }

  async #take(picture: Blob, name: string, step?: PhotoStep): Promise<void> {
    this.#forget();
    this.name = name.replace(/\.[^.]*$/, '');
    const address = URL.createObjectURL(picture);
    this.#address = address;
    const image = new Image();
    image.src = address;
    const [kind, isShown] = await Promise.all([
      kindOf(picture),
      image.decode().then(
        () => true,
        () => false,
      ),
    ]);
    if (this.#address !== address) return;
    const {files} = this.texts.print;
    if (!isShown) {
      const isOther = kind !== undefined && !decodable.has(kind);
      this.trouble = isOther
        ? files.wrongKind(name, files.kinds[kind])
        : kind
          ? files.damaged(name, files.kinds[kind])
          : files.unreadable(name);
      return;
    }
    this.size = {width: image.naturalWidth, height: image.naturalHeight};
    this.session = new PhotoSession(this.workbench.solver, picture);
    if (step) this.session.resume(step);
    else void this.session.begin();
  }

  /** The photograph that the present print was made of, as it was left. */
  async #again(): Promise<void> {
    const {image = ''} = this.workbench.design?.print ?? {};
    const kept = image.startsWith('data:') ? await this.keeper?.kept(image) : undefined;
    if (!kept || this.#address !== undefined) return;
    await this.#take(kept.picture, kept.name, kept.step);
  }

  async #use(session: PhotoSession): Promise<void> {
    const {step} = session;
    if (!step || this.isTaking) return;
    this.isTaking = true;
    this.trouble = undefined;
    try {
      const measures = measuresOf(step);
      const canvas = cellPicture(await session.tile(), measures);
      const image = await dataUrlOf(await pngOf(canvas));
      if (this.session !== session) return;
      this.workbench.doubtful = undefined;
      this.workbench.change({print: {title: this.name || this.words.title, ...measures, image}});
      void this.keeper?.keep(image, {picture: session.picture, name: this.name, step});
      this.#close();
    } catch (error) {
      this.trouble = toFailure(error).message;
    } finally {
      this.isTaking = false;
    }
  }

  /** Letters are keys of the page elsewhere. */
  readonly #key = (event: KeyboardEvent): void => {
    event.stopPropagation();
    const {session} = this;
    const [target] = event.composedPath() as Element[];
    const isField = target?.matches('input:is([type=text], [type=number]), textarea') ?? false;
    if (!session || isField) return;
    if ((event.ctrlKey || event.metaKey) && /^[zy]$/i.test(event.key)) {
      event.preventDefault();
      if (event.shiftKey || event.key.toLowerCase() === 'y') session.redo();
      else session.undo();
    }
    const isPressed = target?.matches('button, a') ?? false;
    if (event.key === 'Enter' && !isPressed && !this.hand && this.#isSure) void this.#use(session);
  };

  readonly #close = (): void => {
    this.renderRoot.querySelector('dialog')?.close();
  };

  readonly #ended = (): void => {
    this.#forget();
  };

  #forget(): void {
    this.session?.dispose();
    this.session = undefined;
    this.size = undefined;
    this.points = undefined;
    this.hand = undefined;
    this.trouble = undefined;
    this.#isLed = false;
    if (this.#address !== undefined) URL.revokeObjectURL(this.#address);
    this.#address = undefined;
  }
}

/** Somewhere in the middle, to be dragged from there. */
const startPoints = ({width, height}: PhotoSize): TwoPoints => [
  [0.25 * width, 0.5 * height],
  [0.75 * width, 0.5 * height],
];

/** A square cell in the middle. */
function startLattice({width, height}: PhotoSize): PhotoMap {
  const side = Math.min(width, height) / 4;
  const [x, y] = [(width - side) / 2, (height + side) / 2];
  return {homography: [side, 0, x, 0, -side, y, 0, 0, 1], lens: 0};
}
