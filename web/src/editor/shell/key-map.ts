/** All keyboard shortcuts. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {Texts} from '../../texts/texts.js';
import type {KeyList} from '../../commands/editor-command.js';
import {keyOf, shortcutIds, shortcuts, titleOf, type ShortcutId} from '../../commands/shortcuts.js';
import type {EditingTool} from '../../workbench/later-tool.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {focused} from '../base/focused.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';

export class KeyMap extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    known: {attribute: false},
    more: {attribute: false},
    view: {},
    tool: {attribute: false},
  };
  /** Commands in addition to those of the pattern. */
  declare known: readonly ShortcutId[];
  /** Returns the keys of another visible view, which work while that view has the focus. */
  declare more: () => KeyList;
  /** The view of those keys. */
  declare view: keyof Texts['pattern']['views'];
  /** Returns the active tool that has keys. */
  declare tool: () => EditingTool | undefined;
  /** The element with the focus before the map; browsers do not restore it inside a shadow root. */
  #before: Element | null = null;

  static override styles = [
    controls,
    css`
      [popover] {
        inset: auto;
        position: fixed;
        right: var(--sw-space-4);
        top: 4rem;
        width: min(30rem, calc(100vw - 2rem));
        max-height: calc(100dvh - 6rem);
      }
      header {
        display: flex;
        align-items: center;
        justify-content: space-between;
      }
      header button {
        width: var(--sw-target);
        padding: 0;
      }
      dl {
        display: grid;
        grid-template-columns: auto 1fr;
        gap: var(--sw-space-1) var(--sw-space-4);
        margin: var(--sw-space-2) 0 0;
      }
      h3 {
        margin-top: var(--sw-space-4);
      }
      dt {
        color: var(--sw-soft);
        white-space: nowrap;
      }
      dd {
        margin: 0;
      }
    `,
  ];

  open(): void {
    this.requestUpdate(); // the keys may have changed
    const map = this.renderRoot.querySelector<HTMLElement>('[popover]');
    // opens at once, so that the map receives the next key
    if (map?.togglePopover()) map.querySelector('button')?.focus();
  }

  protected override render(): TemplateResult {
    const {app, keys} = this.texts;
    const tool = this.tool();
    return html`<div
      popover
      id="keys"
      role="region"
      aria-label=${app.keys}
      @beforetoggle=${({newState}: ToggleEvent) => {
        if (newState === 'open') this.#before = focused();
        else if (this.shadowRoot?.activeElement && this.#before instanceof HTMLElement)
          this.#before.focus();
      }}
    >
      <header>
        <h2>${app.keys}</h2>
        <button aria-label=${app.close} popovertarget="keys" popovertargetaction="hide">
          ${icon.close}
        </button>
      </header>
      <dl>
        ${[...(this.#hasPattern ? keys : []), ...this.#commands()].map(
          ([key, meaning]) =>
            html`<dt>${key}</dt>
              <dd>${meaning}</dd>`,
        )}
      </dl>
      ${tool ? this.#others(tool.title(this.texts), tool.keys) : nothing} ${this.#ofView()}
    </div>`;
  }

  /**
   * False for the fabric layout, which replaces the pattern and uses some of its keys differently.
   */
  get #hasPattern(): boolean {
    return this.view !== 'marker';
  }

  #ofView(): TemplateResult | typeof nothing {
    const {views} = this.texts.pattern;
    return this.#others(views[this.#hasPattern ? 'garment' : 'marker'], this.more());
  }

  #others(heading: string, keys: KeyList): TemplateResult | typeof nothing {
    if (keys.length === 0) return nothing;
    return html`<h3>${heading}</h3>
      <dl>
        ${keys.map(
          ([key, meaning]) =>
            html`<dt>${key}</dt>
              <dd>${meaning}</dd>`,
        )}
      </dl>`;
  }

  #commands(): KeyList {
    const {texts} = this;
    return shortcutIds
      .filter((id) =>
        shortcuts[id].where === 'pattern' ? this.#hasPattern : this.known.includes(id),
      )
      .map((id) => [keyOf(id, texts), titleOf(id, texts)]);
  }
}
