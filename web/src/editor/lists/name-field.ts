/** A name edited in place: Enter and leaving the field keep the entry, Escape discards it. */
import {html, type TemplateResult} from 'lit';

/** Greatest length of a name that fits on a piece. [characters] */
const greatestLength = 80;

interface NameField {
  readonly name: string;
  /** Accessible name of the field. */
  readonly label: string;
  /** @returns true if the name is valid */
  readonly keep: (name: string) => boolean;
  /** Runs after the entry was kept or discarded; `byKey` if the field still has the focus. */
  readonly close: (byKey: boolean) => void;
}

export function nameField({name, label, keep, close}: NameField): TemplateResult {
  let isOpen = true;
  const end = (byKey: boolean): void => {
    isOpen = false;
    close(byKey);
  };
  const press = (event: KeyboardEvent): void => {
    event.stopPropagation(); // letters are no shortcuts here
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
