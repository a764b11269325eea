/** Opens files from the user's computer, and saves files to it. */

/** Opens a file dialog. @returns undefined if the user chooses none */
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
  // the browser reads the URL after this event
  setTimeout(() => {
    URL.revokeObjectURL(url);
  }, 60_000);
}

interface FileTaker {
  readonly take: (file: File) => void;
  /** Reports whether a file is being dragged over the page. */
  readonly hold: (isHeld: boolean) => void;
}

/** Accepts files that are dropped on the page or pasted into it, until `signal` fires. */
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
      if (!relatedTarget) hold(false); // the pointer left the window, not just a part of the page
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

/** First lines of an SVG, DXF or OBJ file, after comments. */
const drawn = /^(?:<(?:\?xml|svg)\b|(?:999\s*\n.*\n\s*)*0\s+SECTION\s|(?:#.*\n\s*)*vt? -?[\d.]+ )/;

/** Returns pasted text of a file; other text belongs to the field that it is pasted into. */
function pastedText({clipboardData}: ClipboardEvent): File | undefined {
  const text = clipboardData?.getData('text/plain').trim() ?? '';
  if (text.startsWith('{')) return new File([text], 'pasted.json', {type: 'application/json'});
  return drawn.test(text) ? new File([text], 'pasted') : undefined;
}
