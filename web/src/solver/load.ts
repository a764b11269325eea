/**
 * The build puts module and .wasm file beside each other into `./module/`, in sources and in `dist`
 * alike: served as they are, by a development server or any other, the files are neighbours, and
 * bundlers know the expression below and emit the file. So neither needs a setting; only Node has to
 * read the file itself.
 */
import createSeamwise, {type ModuleSettings, type SeamwiseModule} from './module/seamwise.mjs';

export type {SeamwiseModule} from './module/seamwise.mjs';

/** How to find the .wasm file, or that it is compiled already. */
export type Settings = ModuleSettings & {readonly module?: WebAssembly.Module};

/** For the .wasm file as a whole, on a bad line. [ms] */
const usualPatience = 60_000;

/** One module instance for everybody, made at the first call; one that broke is replaced. */
export class SharedModule {
  readonly #settings: () => Settings | Promise<Settings>;
  readonly #patience: number;
  #loading: Promise<SeamwiseModule> | null = null;
  #compiled: WebAssembly.Module | undefined;

  /**
   * @param settings how to find the .wasm file; in a page or worker it is found by itself
   * @param patience how long it may take to come [ms]
   */
  constructor(settings: () => Settings | Promise<Settings> = () => ({}), patience = usualPatience) {
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

  /** What the last instance is made of, for other threads to run the very same. */
  get compiled(): WebAssembly.Module | undefined {
    return this.#compiled;
  }

  /** To be called when the module itself broke (out of memory, a trap): it cannot be used again. */
  discard(): void {
    this.#loading = null;
  }

  async #create(): Promise<SeamwiseModule> {
    const settings = await this.#settings();
    let clock: ReturnType<typeof setTimeout> | undefined;
    const created = new Promise<SeamwiseModule>((resolve, reject) => {
      clock = setTimeout(() => {
        reject(new Error(`seamwise.wasm has not come within ${this.#patience / 1000} s`));
      }, this.#patience);
      const instantiateWasm = (
        imports: WebAssembly.Imports,
        receive: (instance: WebAssembly.Instance) => void,
      ) => {
        this.#instantiate(settings, imports).then(receive, reject);
        return {};
      };
      createSeamwise({instantiateWasm, ...settings}).then(resolve, reject);
    });
    return created.finally(() => {
      clearTimeout(clock);
    });
  }

  async #instantiate(
    settings: Settings,
    imports: WebAssembly.Imports,
  ): Promise<WebAssembly.Instance> {
    const module = await compiled(settings);
    const instance = await WebAssembly.instantiate(module, imports);
    this.#compiled = module;
    return instance;
  }

  #forget(loading: Promise<SeamwiseModule>): void {
    if (this.#loading === loading) this.#loading = null;
  }
}

/** As it comes, where the host says exactly what it is. @throws what kept the file from being had */
async function compiled({module, wasmBinary, locateFile}: Settings): Promise<WebAssembly.Module> {
  if (module) return module;
  if (wasmBinary) return WebAssembly.compile(wasmBinary as BufferSource);
  const url =
    locateFile?.('seamwise.wasm', '') ?? new URL('./module/seamwise.wasm', import.meta.url);
  const response = await fetch(url, {credentials: 'same-origin'});
  if (!response.ok) throw new Error(`${response.url} is answered with HTTP ${response.status}`);
  return response.headers.get('Content-Type') === 'application/wasm'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}
