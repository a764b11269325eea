/** A name that is edited in its place: Enter and leaving it keep what was typed, Escape does not. */
import {html, type TemplateResult} from 'lit';

/** What fits on a piece. [characters] */
const greatestLength = 80;

interface NameField {
  readonly name: string;
  /** For those who do not see it. */
  readonly label: string;
  /** @returns whether the name is a good one */
  readonly keep: (name: string) => boolean;
  /** After it was kept or given up; `byKey` when the focus is still here. */
  readonly close: (byKey: boolean) => void;
}

export function nameField({name, label, keep, close}: NameField): TemplateResult {
  let isOpen = true;
  const end = (byKey: boolean): void => {
    isOpen = false;
    close(byKey);
  };
  const press = (event: KeyboardEvent): void => {
    event.stopPropagation(); // letters are no commands here
    const field = event.target as HTMLInputElement;
    if (event.key === 'Escape') end(true);
    else if (event.key === 'Enter' && keep(field.value.trim())) end(true);
  };
  return html`<input
    class="name"
    type="text"
    aria-label=${label}
    maxlength=${greatestLength}
    .value=${name}
    @keydown=${press}
    @blur=${({target}: Event) => {
      if (!isOpen) return;
      keep((target as HTMLInputElement).value.trim());
      end(false);
    }}
  />`;
}
