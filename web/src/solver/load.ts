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
