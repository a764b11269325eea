/**
 * Loads pdf.js in Node and in workers. Only its operator lists are used: nothing is drawn, executed
 * or fetched.
 */
import type {OperatorPort} from './operator-port.js';

type Library = typeof import('pdfjs-dist/legacy/build/pdf.mjs');

interface PdfJs {
  readonly library: Library;
  /** Connects the library and its parser, both in this thread, by a port. */
  readonly connect: (port: OperatorPort) => InstanceType<Library['PDFWorker']>;
}

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

/** Returns pdf.js, once it is loaded. */
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
    const connect: PdfJs['connect'] = (port) => {
      const worker = new library.PDFWorker({port: port as unknown as null, verbosity: 0});
      parser.WorkerMessageHandler.initializeFromPort(port);
      return worker;
    };
    return {library, connect};
  } finally {
    for (const name of added) Reflect.deleteProperty(scope, name);
  }
}
