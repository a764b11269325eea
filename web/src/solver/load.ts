/**
 * The build puts module and .wasm file beside each other into `./module/`, in sources and in `dist`
 * alike. By itself the module fetches `new URL('seamwise.wasm', import.meta.url)`: served as they are,
 * by a development server or any other, the files are neighbours, and bundlers know the expression
 * and emit the file. So neither needs a setting; only Node has to read the file itself.
 */
import createSeamwise, {type ModuleSettings, type SeamwiseModule} from './module/seamwise.mjs';

export type {SeamwiseModule} from './module/seamwise.mjs';

/** For the .wasm file as a whole, on a bad line. [ms] */
const usualPatience = 60_000;

/** One module instance for everybody, made at the first call; one that broke is replaced. */
export class SharedModule {
  readonly #settings: () => ModuleSettings | Promise<ModuleSettings>;
  readonly #patience: number;
  #loading: Promise<SeamwiseModule> | null = null;

  /**
   * @param settings how to find the .wasm file; in a page or worker it is found by itself
   * @param patience how long it may take to come [ms]
   */
  constructor(
    settings: () => ModuleSettings | Promise<ModuleSettings> = () => ({}),
    patience = usualPatience,
  ) {
    this.#settings = settings;
    this.#patience = patience;
  }

  /** @throws whatever kept the module from loading; the next call tries again */
  load(): Promise<SeamwiseModule> {
    const loading = (this.#loading ??= this.#create());
    loading.catch(() => {
      this.#forget(loading);
    });
    return loading;
  }

  /** To be called when the module itself broke (out of memory, a trap): it cannot be used again. */
  discard(): void {
    this.#loading = null;
  }

  async #create(): Promise<SeamwiseModule> {
    const settings = await this.#settings();
    const begun = performance.now();
    let clock: ReturnType<typeof setTimeout> | undefined;
    const late = new Promise<never>((_, reject) => {
      clock = setTimeout(() => {
        reject(new Error(`seamwise.wasm has not come within ${this.#patience / 1000} s`));
      }, this.#patience);
    });
    try {
      return await Promise.race([createSeamwise(settings), late]);
    } catch (error) {
      throw (await refusal(begun)) ?? error;
    } finally {
      clearTimeout(clock);
    }
  }

  #forget(loading: Promise<SeamwiseModule>): void {
    if (this.#loading === loading) this.#loading = null;
  }
}

/** Browsers tell of what was fetched a little later than it is there. [ms] */
const hearsay = 100;

/** What a host has answered since then in place of the file: the module itself says only that it is empty. */
async function refusal(begun: number): Promise<Error | undefined> {
  await new Promise((resolve) => setTimeout(resolve, hearsay));
  const entries = performance.getEntriesByType('resource') as readonly {
    readonly name: string;
    readonly startTime: number;
    readonly responseStatus?: number; // where the browser says it
  }[];
  for (const {name, startTime, responseStatus = 0} of entries) {
    const isRefused = startTime >= begun && responseStatus >= 400;
    if (isRefused && /\.wasm([?#]|$)/.test(name)) {
      return new Error(`${name} is answered with HTTP ${responseStatus}`);
    }
  }
  return undefined;
}
