// The project's own worker, except that it breaks some time after it gets garments with these
// names.
import type {ProblemTexts} from '../../../../web/src/solver/requests/requests.js';
import '../../../../web/src/solver/solver.worker.js';

const breaks: Readonly<Record<string, () => void>> = {
  throws: () => {
    throw new Error('out of order');
  },
  traps: () => {
    // The solver reads the clock between any two steps, so it meets this error as it would meet a
    // trap.
    performance.now = () => {
      throw new WebAssembly.RuntimeError('unreachable');
    };
  },
  closes: () => {
    self.close();
  },
  hangs: () => {
    new BroadcastChannel('hangs').postMessage('from now on');
    for (;;);
  },
  pauses: () => {
    new BroadcastChannel('hangs').postMessage('for some seconds');
    const started = Date.now();
    while (Date.now() - started < 3000);
  },
};

interface Message {
  readonly request?: Partial<ProblemTexts>;
}

self.addEventListener('message', ({data: {request}}: MessageEvent<Message>) => {
  setTimeout(breaks[request?.garmentName ?? ''] ?? (() => null), 300);
});
