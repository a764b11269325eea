/** Dialog that makes a print from a photo of fabric. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {PhotoMap} from '../../model/print/photo-reading.js';
import {dataUrlOf} from '../../image/data-url.js';
import {photoTexts, type PhotoTexts} from '../../texts/photo-texts.js';
import {toFailure} from '../../workbench/latest-solve.js';
import {focused} from '../base/focused.js';
import {takePrint} from '../../workbench/print/take-print.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import type {PhotoOfFabric} from '../../print/openable-files.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {sheetDialog} from '../style/sheet-dialog.js';
import {adviceStyle, photoAdvice} from './photo-advice.js';
import {startLattice, type PhotoSize} from '../../photo/lattice-lines.js';
import type {PhotoKeeper} from '../../photo/photo-keeper.js';
import {cellPicture, pngOf} from '../../photo/photo-picture.js';
import {
  PhotoSession,
  UnfinishedWork,
  type PhotoBefore,
} from '../../workbench/photo/photo-session.js';
import {areSame, isDoubtful, measuresOf, type PhotoStep} from '../../photo/photo-step.js';
import {shownPicture} from '../../print/read-picture.js';

/** Styles in addition to `sheetDialog`. */
const dialogStyle = css`
  dialog {
    width: min(80rem, calc(100vw - 2rem));
  }
  header,
  footer {
    gap: var(--sw-space-2);
    padding: var(--sw-space-3) var(--sw-space-4);
  }
  h2 {
    flex: 1;
    font-size: var(--sw-text-large);
  }
  dialog:has(.intake) {
    width: min(44rem, calc(100vw - 2rem));
  }
  .doubt {
    flex-basis: 100%;
  }
  .name {
    display: flex;
    flex: 1 1 12rem;
    align-items: center;
    gap: var(--sw-space-2);
  }
  .name input {
    min-width: 0;
    color: var(--sw-ink);
  }
  .intake {
    display: grid;
    gap: var(--sw-space-3);
    padding: var(--sw-space-6) var(--sw-space-4);
  }
  .row {
    display: flex;
    flex-wrap: wrap;
    gap: var(--sw-space-2);
  }
  @media not (pointer: coarse) {
    .camera {
      display: none;
    }
  }
  @media (width < 48rem) {
    dialog,
    dialog:has(.intake) {
      width: 100vw;
      height: 100dvh;
      max-height: none;
      margin: 0;
      border: 0;
      border-radius: 0;
    }
    header,
    footer {
      padding: var(--sw-space-2) var(--sw-space-3);
    }
  }
`;

interface PictureButton {
  readonly label: string;
  /** CSS class. */
  readonly look: 'primary' | 'outlined';
  /** Opens the camera on phones. */
  readonly isCamera?: boolean;
  readonly take: (file: File) => void;
}

/** A button that opens an image file. */
function pictureButton({label, look, isCamera, take}: PictureButton): TemplateResult {
  return html`<span class=${isCamera ? 'camera' : ''}>
    <input
      type="file"
      hidden
      accept="image/*"
      capture=${isCamera ? 'environment' : nothing}
      @change=${(event: Event) => {
        const input = event.target as HTMLInputElement;
        const [file] = input.files ?? [];
        if (file) take(file);
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

/**
 * Foot of the photo dialog: name, another image, a cell drawn by hand, and the button that makes
 * the print.
 */
interface PhotoFoot {
  readonly words: PhotoTexts;
  readonly session: PhotoSession;
  /** Problem with making the print. */
  readonly trouble: string | undefined;
  readonly name: string;
  readonly isDrawing: boolean;
  readonly isTaking: boolean;
  readonly rename: (name: string) => void;
  readonly take: (file: File) => void;
  readonly draw: () => void;
  readonly use: () => void;
}

function photoFoot(foot: PhotoFoot): TemplateResult {
  const {words, trouble, isDrawing} = foot;
  const {step, state} = foot.session.read;
  const isReading = state.kind === 'reading';
  const isReady = step !== undefined && !isDrawing && !isReading;
  const isDoubted = isReady && isDoubtful(step);
  return html`<footer>
    ${trouble && state.kind !== 'failed' ? html`<p class="error" role="alert">${trouble}</p>` : nothing}
    ${isDoubted ? html`<p class="doubt" id="doubt">${words.doubt}</p>` : nothing}
    <label class="name">
      ${words.name}
      <input
        type="text"
        maxlength="80"
        .value=${foot.name}
        @change=${(event: Event) => {
          foot.rename((event.target as HTMLInputElement).value);
        }}
      />
    </label>
    ${pictureButton({label: words.another, look: 'outlined', take: foot.take})}
    <button class="outlined" ?disabled=${isDrawing || isReading} @click=${foot.draw}>
      ${words.byHand}
    </button>
    <button
      class=${isDoubted ? 'outlined' : 'primary'}
      aria-describedby=${isDoubted ? 'doubt' : nothing}
      ?disabled=${!isReady || foot.isTaking}
      @click=${foot.use}
    >
      ${isDoubted ? words.useDoubtful : words.use}
    </button>
  </footer>`;
}

interface Intake {
  readonly words: PhotoTexts;
  /** Problem with the given image. */
  readonly trouble: string | undefined;
  readonly take: (file: File) => void;
}

/** Buttons to choose or take a photo, with advice on taking it. */
function photoIntake({words, trouble, take}: Intake): TemplateResult {
  return html`<div class="intake">
    <p>${words.intake}</p>
    ${photoAdvice(words)}
    <p class="soft">${words.stays}</p>
    ${trouble ? html`<p class="error" role="alert">${trouble}</p>` : nothing}
    <div class="row">
      ${pictureButton({label: words.choose, look: 'primary', take})}
      ${pictureButton({label: words.camera, look: 'outlined', isCamera: true, take})}
    </div>
  </div>`;
}

export class PhotoDialog extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    session: {state: true},
    size: {state: true},
    hand: {state: true},
    name: {state: true},
    trouble: {state: true},
    isTaking: {state: true},
  };
  static override styles = [controls, sheetDialog, dialogStyle, adviceStyle];
  /** Undefined until there is an image. */
  declare protected session: PhotoSession | undefined;
  /** Size of the image as the browser shows it. */
  declare protected size: PhotoSize | undefined;
  /** Lattice drawn by the user. */
  declare protected hand: PhotoMap | undefined;
  declare protected name: string;
  /** Problem with the image, or with making the print. */
  declare protected trouble: string | undefined;
  declare protected isTaking: boolean;
  keeper: PhotoKeeper | undefined;
  #address: string | undefined;
  /** The kept step, until the user changes it. */
  #resumed: PhotoStep | undefined;
  /** Image of the design's print when the dialog was closed with unfinished work. */
  #leftAt: string | undefined;
  readonly #unfinished = new UnfinishedWork(() => ({keeper: this.keeper, image: this.#image}));
  /** True once the focus has moved to the button that makes the print. */
  #isLed = false;

  constructor() {
    super();
    this.name = '';
    this.isTaking = false;
  }

  async open(given?: PhotoOfFabric): Promise<void> {
    await this.updateComplete;
    const dialog = this.renderRoot.querySelector('dialog');
    if (!dialog?.open) dialog?.showModal();
    if (!given) await this.#again();
    else if (!(await this.#isAt(given.picture))) await this.#take(given.picture, given.name);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#forget();
  }

  /** True if the result needs no check by the user. */
  get #isSure(): boolean {
    const {state, step} = this.session ?? {};
    return state?.kind === 'done' && step !== undefined && !isDoubtful(step);
  }

  protected get words(): PhotoTexts {
    const {language, messages} = this.workbench.preferences.chosen;
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
      ${session && this.size ? [this.#work(session, this.size), this.#foot(session, this.size)] : photoIntake({words, trouble: this.trouble, take: this.#given})}
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

  #work(session: PhotoSession, size: PhotoSize): TemplateResult {
    return html`<sw-photo-work
      .workbench=${this.workbench}
      .session=${session}
      .picture=${this.#address ?? ''}
      .natural=${size}
      .hand=${this.hand}
      @hand=${({detail}: CustomEvent<PhotoMap | null>) => {
        this.hand = detail ?? undefined;
      }}
    ></sw-photo-work>`;
  }

  #foot(session: PhotoSession, natural: PhotoSize): TemplateResult {
    const {words, name, trouble, isTaking} = this;
    return photoFoot({
      ...{words, session, name, trouble, isTaking},
      isDrawing: this.hand !== undefined,
      take: this.#given,
      rename: (given) => {
        this.name = given;
        this.#keep(session);
      },
      draw: () => {
        this.hand = startLattice(session.step?.reading ?? natural);
      },
      use: () => void this.#use(session),
    });
  }

  readonly #given = (file: File): void => {
    void this.#take(file, file.name);
  };

  #hand(event: Event, file: File | undefined): void {
    event.stopPropagation(); // the page accepts files, too
    if (!file) return;
    event.preventDefault();
    this.#given(file);
  }

  async #take(picture: Blob, name: string, before?: PhotoBefore): Promise<void> {
    this.#forget();
    this.name = name.replace(/\.[^.]*$/, '');
    const address = URL.createObjectURL(picture);
    this.#address = address;
    const shown = await shownPicture(picture, {address, name}, this.texts.print.files);
    if (this.#address !== address) return;
    if (typeof shown === 'string') {
      this.trouble = shown;
      return;
    }
    this.size = shown;
    const session = new PhotoSession(this.workbench.solver, picture);
    this.session = session;
    if (before?.isFinished) this.#resumed = before.history?.present;
    if (before?.history) session.resume(before.history);
    else void session.begin();
    if (before && !before.isFinished) this.#unfinished.resume(session, this.name);
    session.subscribe(() => {
      this.#keep(session);
    });
    this.#keep(session);
  }

  /** Keeps the work for a reload of the page. */
  #keep(session: PhotoSession): void {
    const isFinished = session.step !== undefined && session.step === this.#resumed;
    if (!isFinished) this.#unfinished.keep(session, this.name);
  }

  /** Discards the work for good. */
  #drop(): void {
    this.#unfinished.drop();
    this.#forget();
  }

  get #image(): string {
    return this.workbench.history.design?.print.image ?? '';
  }

  /**
   * Restores the unfinished photo; after a change of the print, the photo that the new print was
   * made from.
   */
  async #again(): Promise<void> {
    const image = this.#image;
    const address = this.#address;
    if (address !== undefined && image === this.#leftAt) return;
    const found = await this.#unfinished.find(address !== undefined);
    if (!found || this.#address !== address) return;
    await this.#take(found.picture, found.name, found);
  }

  /** Returns whether this image is the one left unfinished. */
  async #isAt(picture: Blob): Promise<boolean> {
    const {session} = this;
    return (
      session !== undefined && (await areSame(session.picture, picture)) && this.session === session
    );
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
      this.workbench.notices.doubtful = undefined;
      const title = this.name || this.words.title;
      takePrint(this.workbench, {title, ...measures, image, isPrinted: true});
      void this.keeper?.keep(image, {picture: session.picture, name: this.name, step});
      this.#close();
      this.#drop();
    } catch (error) {
      this.trouble = toFailure(error).message;
    } finally {
      this.isTaking = false;
    }
  }

  /** Stops keys here, since letters are shortcuts of the page. */
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

  /** Keeps unfinished work for the next time that the dialog opens. */
  readonly #ended = (): void => {
    const {step, state} = this.session ?? {};
    const isUnfinished =
      this.hand !== undefined || (step ? step !== this.#resumed : state?.kind === 'reading');
    if (isUnfinished) this.#leftAt = this.#image;
    else this.#drop();
  };

  #forget(): void {
    this.session?.dispose();
    this.session = undefined;
    this.size = undefined;
    this.hand = undefined;
    this.trouble = undefined;
    this.#resumed = undefined;
    this.#unfinished.leave();
    this.#isLed = false;
    if (this.#address !== undefined) URL.revokeObjectURL(this.#address);
    this.#address = undefined;
  }
}
