/** Where a module's .wasm file is, if not where the build has put it; or its bytes; or what is compiled of them already. */
type WasmSource = string | URL | BufferSource | WebAssembly.Module;

/** Asked for with every attempt to load a module. */
type Source = () => WasmSource | undefined | Promise<WasmSource>;

/** What modules offer, by their names. */
export type Modules = Readonly<Record<string, unknown>>;

/** By the modules' names. */
export type WasmSources<Ms extends Modules> = Readonly<Partial<Record<keyof Ms, Source>>>;

/** How a module is had. */
export interface ModuleLoader<M> {
  /** What its file is called in messages. */
  readonly file: string;
  /** Where the build has put it. */
  readonly url: URL;
  /** Makes an instance. */
  readonly create: (compiled: WebAssembly.Module) => Promise<M>;
}

/** For a .wasm file as a whole, on a bad line. [ms] */
const usualPatience = 60_000;

/** One module instance for everybody, made at the first call; one that broke is replaced. */
export class SharedModule<M> {
  readonly #loader: ModuleLoader<M>;
  readonly #source: Source | undefined;
  readonly #patience: number;
  #loading: Promise<M> | null = null;
  #compiled: WebAssembly.Module | undefined;

  /**
   * @param source where to find its file; in a page or worker it is found by itself
   * @param patience how long it may take to come [ms]
   */
  constructor(loader: ModuleLoader<M>, source?: Source, patience = usualPatience) {
    this.#loader = loader;
    this.#source = source;
    this.#patience = patience;
  }

  /** @throws whatever kept the module from loading; the next call tries again */
  load(): Promise<M> {
    const loading = (this.#loading ??= this.#create());
    loading.catch(() => {
      if (this.#loading === loading) this.#loading = null;
    });
    return loading;
  }

  /** What the last instance is made of. */
  get compiled(): WebAssembly.Module | undefined {
    return this.#compiled;
  }

  /** To be called when the module itself broke (out of memory, a trap): it cannot be used again. */
  discard(): void {
    this.#loading = null;
  }

  get file(): string {
    return this.#loader.file;
  }

  #create(): Promise<M> {
    let clock: ReturnType<typeof setTimeout> | undefined;
    const late = new Promise<never>((_, reject) => {
      clock = setTimeout(() => {
        reject(new Error(`${this.file} has not come within ${this.#patience / 1000} s`));
      }, this.#patience);
    });
    return Promise.race([this.#instantiate(), late]).finally(() => {
      clearTimeout(clock);
    });
  }

  async #instantiate(): Promise<M> {
    const compiled = await compile((await this.#source?.()) ?? this.#loader.url);
    const module = await this.#loader.create(compiled);
    this.#compiled = compiled;
    return module;
  }
}

/** As it comes, where the host says exactly what it is. @throws what kept the file from being had */
async function compile(source: WasmSource): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) {
    return WebAssembly.compile(source);
  }
  const response = await fetch(source, {credentials: 'same-origin'});
  if (!response.ok) throw new Error(`${response.url} is answered with HTTP ${response.status}`);
  return response.headers.get('Content-Type') === 'application/wasm'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}
