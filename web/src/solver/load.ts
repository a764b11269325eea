/**
 * The build puts module and .wasm file beside each other into `./module/`, in sources and in `dist`
 * alike. By itself the module fetches `new URL('seamwise.wasm', import.meta.url)`: served as they are,
 * by a development server or any other, the files are neighbours, and bundlers know the expression
 * and emit the file. So neither needs a setting; only Node has to read the file itself.
 */
import createSeamwise, {type ModuleSettings, type SeamwiseModule} from './module/seamwise.mjs';

export type {SeamwiseModule} from './module/seamwise.mjs';

/** One module instance for everybody, made at the first call; one that broke is replaced. */
export class SharedModule {
  readonly #settings: () => ModuleSettings | Promise<ModuleSettings>;
  #loading: Promise<SeamwiseModule> | null = null;

  /** @param settings how to find the .wasm file; in a page or worker it is found by itself */
  constructor(settings: () => ModuleSettings | Promise<ModuleSettings> = () => ({})) {
    this.#settings = settings;
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
    return createSeamwise(await this.#settings());
  }

  #forget(loading: Promise<SeamwiseModule>): void {
    if (this.#loading === loading) this.#loading = null;
  }
}
