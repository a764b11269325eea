/**
 * Loads pdf.js in Node and in workers. Only its operator lists are used: nothing is drawn, executed
 * or fetched.
 */
type PdfJs = typeof import('pdfjs-dist/legacy/build/pdf.mjs');

/** Globals of browsers that pdf.js requires while its modules are evaluated, and only there. */
const placeholders: Readonly<Record<string, unknown>> = {
  DOMMatrix: Object,
  ImageData: Object,
  Path2D: Object,
  navigator: {language: 'en-US', platform: '', userAgent: ''},
  // Without a window, pdf.js in a worker would take over the worker's messages.
  window: globalThis,
};

let loaded: Promise<PdfJs> | undefined;

/** Returns pdf.js, with its parser in this thread. */
export const pdfJs = (): Promise<PdfJs> => (loaded ??= load());

async function load(): Promise<PdfJs> {
  const scope = globalThis as Record<string, unknown>;
  const added = Object.keys(placeholders).filter((name) => scope[name] === undefined);
  for (const name of added) scope[name] = placeholders[name];
  try {
    const [library, parser] = await Promise.all([
      import('pdfjs-dist/legacy/build/pdf.mjs'),
      import('pdfjs-dist/legacy/build/pdf.worker.mjs'),
    ]);
    scope.pdfjsWorker = parser;
    return library;
  } finally {
    for (const name of added) Reflect.deleteProperty(scope, name);
  }
}
