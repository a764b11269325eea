/** Command palette: a search field, and a list to choose from. */
import {html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import {controls} from '../../editor/style/controls.js';
import {WorkbenchElement} from '../../editor/base/workbench-element.js';
import {focused} from '../../editor/base/focused.js';
import type {Command} from '../../commands/editor-command.js';
import {paletteStyle} from './palette-style.js';

// Searches commands by a few words.

/** Folds a text for comparison: no capitals and no diacritics. */
export const folded = (text: string): string =>
  text
    .normalize('NFD')
    .replace(/\p{M}/gu, '')
    .toLowerCase()
    .replaceAll('ß', 'ss')
    .replaceAll('œ', 'oe')
    .replaceAll('æ', 'ae');

const wordsIn = (text: string): readonly string[] =>
  folded(text)
    .split(/[^\p{L}\p{N}]+/u)
    .filter((word) => word !== '');

/**
 * Returns the rank of a command, 0 best; undefined if a word does not occur. Unavailable commands
 * come after available ones.
 */
function rank({title, words = '', why}: Command, wanted: readonly string[]): number | undefined {
  const named = wordsIn(title);
  const called = wordsIn(words);
  const ranks = wanted.map((word) => {
    if (named.some((one) => one.startsWith(word))) return 0;
    if (called.some((one) => one.startsWith(word))) return 1;
    return [...named, ...called].some((one) => one.includes(word)) ? 2 : 3;
  });
  const worst = Math.max(0, ...ranks);
  if (worst === 3) return undefined;
  return worst + (why === undefined ? 0 : 3);
}

/**
 * Returns the commands that contain all typed words, whole or in part, the best first, otherwise in
 * their own order.
 */
export function matching(commands: readonly Command[], typed: string): readonly Command[] {
  const wanted = wordsIn(typed);
  if (wanted.length === 0) return commands;
  return commands
    .flatMap((command) => {
      const fit = rank(command, wanted);
      return fit === undefined ? [] : [{command, fit}];
    })
    .sort((a, b) => a.fit - b.fit)
    .map(({command}) => command);
}

/** Number of rows for PageUp and PageDown. */
const page = 8;

export class CommandPalette extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    commands: {attribute: false},
    typed: {state: true},
    active: {state: true},
    isOpen: {state: true},
  };
  static override styles = [controls, paletteStyle];
  /** Returns the currently available commands. */
  declare commands: () => readonly Command[];
  declare protected typed: string;
  /** Command for Enter, by its id; the first unless another is selected. */
  declare protected active: string | undefined;
  declare protected isOpen: boolean;
  /** Previously focused element; browsers forget it inside a shadow root. */
  #before: Element | null = null;
  #shown: readonly Command[] = [];

  constructor() {
    super();
    this.commands = () => [];
    this.typed = '';
    this.isOpen = false;
  }

  /** Opens or closes the palette. */
  async toggle(): Promise<void> {
    if (this.isOpen) {
      this.#dialog?.close();
      return;
    }
    this.#before = focused();
    this.typed = '';
    this.active = undefined;
    this.isOpen = true;
    await this.updateComplete;
    this.#dialog?.showModal();
    this.#field?.focus();
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (!this.isOpen) return;
    this.#shown = matching(this.commands(), this.typed);
    if (!this.#shown.some(({id}) => id === this.active)) this.active = this.#shown[0]?.id;
  }

  protected override render(): TemplateResult {
    const {commands} = this.texts;
    return html`<dialog
      aria-label=${commands.title}
      @close=${this.#closed}
      @click=${(event: Event) => {
        // a click on the dialog element itself hits its backdrop
        if (event.target === event.currentTarget) this.#dialog?.close();
      }}
    >
      ${this.isOpen ? this.#inside() : nothing}
    </dialog>`;
  }

  protected override updated(): void {
    this.renderRoot.querySelector('[aria-selected=true]')?.scrollIntoView({block: 'nearest'});
  }

  #inside(): TemplateResult {
    const {commands, app} = this.texts;
    const shown = this.#shown;
    const at = shown.findIndex(({id}) => id === this.active);
    return html`<div class="inside">
      <div class="head">
        <input
          type="text"
          role="combobox"
          aria-label=${commands.look}
          aria-expanded="true"
          aria-controls="list"
          aria-autocomplete="list"
          aria-activedescendant=${at < 0 ? nothing : `command-${at}`}
          placeholder=${commands.look}
          autocomplete="off"
          autocapitalize="off"
          spellcheck="false"
          enterkeyhint="go"
          .value=${this.typed}
          @input=${({target}: Event) => {
            this.typed = (target as HTMLInputElement).value;
            this.active = undefined;
          }}
          @keydown=${this.#key}
        />
        <button
          class="outlined"
          @click=${() => {
            this.#dialog?.close();
          }}
        >
          ${app.close}
        </button>
      </div>
      <div
        id="list"
        role="listbox"
        aria-label=${commands.title}
        tabindex="-1"
        @pointerdown=${(event: Event) => {
          event.preventDefault(); // the field keeps the focus
        }}
      >
        ${shown.map((command, k) => this.#option(command, k))}
      </div>
      <p class=${shown.length > 0 ? 'hidden' : 'soft none'} role="status">
        ${shown.length > 0 ? commands.count(shown.length) : commands.none}
      </p>
    </div>`;
  }

  #option(command: Command, k: number): TemplateResult {
    const {id, title, key, why} = command;
    return html`<div
      id="command-${k}"
      role="option"
      aria-selected=${id === this.active}
      aria-disabled=${why === undefined ? nothing : 'true'}
      @click=${() => {
        this.#run(command);
      }}
      @pointermove=${() => {
        this.active = id;
      }}
    >
      <span>${title}</span>
      ${why === undefined ? nothing : html`<span class="why">${why}</span>`}
      ${key === undefined ? nothing : html`<kbd>${key}</kbd>`}
    </div>`;
  }

  readonly #key = (event: KeyboardEvent): void => {
    const shown = this.#shown;
    const at = shown.findIndex(({id}) => id === this.active);
    const last = shown.length - 1;
    const to = {
      ArrowDown: at === last ? 0 : at + 1,
      ArrowUp: at <= 0 ? last : at - 1,
      PageDown: Math.min(last, at + page),
      PageUp: Math.max(0, at - page),
    }[event.key];
    if (to !== undefined) this.active = shown[to]?.id;
    else if (event.key === 'Enter' && !event.isComposing && shown[at]) this.#run(shown[at]);
    else return;
    event.preventDefault();
  };

  #run({why, run}: Command): void {
    if (why !== undefined) return;
    this.#dialog?.close();
    this.#giveBack();
    run();
  }

  /** Restores the focus; the command may move it afterwards. */
  #giveBack(): void {
    const before = this.#before;
    this.#before = null;
    if (before instanceof HTMLElement && before !== document.body) before.focus();
  }

  readonly #closed = (): void => {
    this.isOpen = false;
    this.#giveBack();
  };

  get #dialog(): HTMLDialogElement | null {
    return this.renderRoot.querySelector('dialog');
  }

  get #field(): HTMLInputElement | null {
    return this.renderRoot.querySelector('input');
  }
}
