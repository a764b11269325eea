import type {SolveHooks} from '../model/problem.js';
import {LocalSolver} from './local.js';
import type {Answers, QuestionOf} from './protocol.js';
import type {Pace} from './run.js';
import {TextService} from './service.js';
import type {WorkerPlaces} from './watched-worker.js';

/**
 * Half a frame, to leave the other half to the page. A message, because setTimeout would wait 4 ms or
 * more, a second in a hidden page; and because it queues behind what the page has to do already.
 */
const besideThePage: Pace = {
  slice: 8,
  pause: () =>
    new Promise((resolve) => {
      const {port1, port2} = new MessageChannel();
      port1.onmessage = () => {
        port1.close();
        resolve();
      };
      port2.postMessage(null);
    }),
};

/**
 * The solver on the page's own thread, in slices of a few milliseconds: for pages that may have no
 * worker. What cannot be cut (meshing, one factorisation) still holds up the page, on a large garment for
 * some tenths of a second.
 */
export class MainThreadSolver extends TextService {
  readonly #solver: LocalSolver;

  constructor({wasmUrl}: Pick<WorkerPlaces, 'wasmUrl'> = {}) {
    super();
    const settings = () =>
      wasmUrl === undefined ? {} : {locateFile: () => new URL(wasmUrl, document.baseURI).href};
    this.#solver = new LocalSolver(settings, besideThePage);
  }

  ask<K extends keyof Answers>(question: QuestionOf<K>, hooks: SolveHooks): Promise<Answers[K]> {
    return this.#solver.answer<K>(question, hooks);
  }
}
