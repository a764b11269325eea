/** Files from the user's machine and to it. */

/** Asks for a file. @returns undefined when nothing is chosen */
export function chooseFile(accept: string): Promise<File | undefined> {
  return new Promise((resolve) => {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = accept;
    input.addEventListener('change', () => {
      resolve(input.files?.[0]);
    });
    input.addEventListener('cancel', () => {
      resolve(undefined);
    });
    input.click();
  });
}

export function saveFile(name: string, content: Blob | string, type = 'application/json'): void {
  const blob = typeof content === 'string' ? new Blob([content], {type}) : content;
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // the browser reads it after this event
  setTimeout(() => {
    URL.revokeObjectURL(url);
  }, 60_000);
}

interface FileTaker {
  readonly take: (file: File) => void;
  /** A file is held over the page, or is not any more. */
  readonly hold: (isHeld: boolean) => void;
}

/** Takes files that are dropped on the page or pasted into it, until `signal` fires. */
export function takeFiles({take, hold}: FileTaker, signal: AbortSignal): void {
  addEventListener(
    'dragover',
    (event) => {
      if (!event.dataTransfer?.types.includes('Files')) return;
      event.preventDefault();
      hold(true);
    },
    {signal},
  );
  addEventListener(
    'dragleave',
    ({relatedTarget}) => {
      if (!relatedTarget) hold(false); // out of the window, not into another part of the page
    },
    {signal},
  );
  addEventListener(
    'drop',
    (event) => {
      hold(false);
      const file = event.dataTransfer?.files[0];
      if (!file) return;
      event.preventDefault();
      take(file);
    },
    {signal},
  );
  addEventListener(
    'paste',
    (event) => {
      const file = event.clipboardData?.files[0] ?? pastedText(event);
      if (!file) return;
      event.preventDefault();
      take(file);
    },
    {signal},
  );
}

/** How the text of a drawing begins: of an SVG, a DXF or an OBJ, comments before it. */
const drawn = /^(?:<(?:\?xml|svg)\b|(?:999\s*\n.*\n\s*)*0\s+SECTION\s|(?:#.*\n\s*)*vt? -?[\d.]+ )/;

/** The text of a file, copied out of an editor; other text belongs to whatever field it is pasted into. */
function pastedText({clipboardData}: ClipboardEvent): File | undefined {
  const text = clipboardData?.getData('text/plain').trim() ?? '';
  if (text.startsWith('{')) return new File([text], 'pasted.json', {type: 'application/json'});
  return drawn.test(text) ? new File([text], 'pasted') : undefined;
}
