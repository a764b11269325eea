import {html, nothing, type TemplateResult} from 'lit';

interface PictureButton {
  readonly label: string;
  /** CSS class. */
  readonly look: 'primary' | 'outlined';
  /** Opens the camera on phones. */
  readonly isCamera?: boolean;
  readonly take: (file: File) => void;
}

/** A button that opens an image file. */
export function pictureButton({label, look, isCamera, take}: PictureButton): TemplateResult {
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
