/**
 * A module's .wasm file as URL or bytes, or the compiled module. Default: the URL from the build.
 */
type WasmSource = string | URL | BufferSource | WebAssembly.Module;

/** Called for every attempt to load a module. */
type Source = () => WasmSource | undefined | Promise<WasmSource>;

/** Interfaces of modules, by name. */
export type Modules = Readonly<Record<string, unknown>>;

/** Sources of modules, by name. */
export type WasmSources<Ms extends Modules> = Readonly<Partial<Record<keyof Ms, Source>>>;

/** Loader of a module. */
export interface ModuleLoader<M> {
  /** Name of its file in messages. */
  readonly file: string;
  /** URL of its file from the build. */
  readonly url: URL;
  /** Creates an instance. */
  readonly create: (compiled: WebAssembly.Module) => Promise<M>;
}

/** Time limit for a whole .wasm file on a slow connection. [ms] */
const usualPatience = 60_000;

/** A shared instance of a module, created at the first call; a broken one is replaced. */
export class SharedModule<M> {
  readonly #loader: ModuleLoader<M>;
  readonly #source: Source | undefined;
  readonly #patience: number;
  #loading: Promise<M> | null = null;
  #compiled: WebAssembly.Module | undefined;

  /**
   * @param source source of its file; a page or worker needs none
   * @param patience time limit for loading [ms]
   */
  constructor(loader: ModuleLoader<M>, source?: Source, patience = usualPatience) {
    this.#loader = loader;
    this.#source = source;
    this.#patience = patience;
  }

  /** Returns the instance. @throws the error that prevented loading; the next call tries again */
  load(): Promise<M> {
    const loading = (this.#loading ??= this.#create());
    loading.catch(() => {
      if (this.#loading === loading) this.#loading = null;
    });
    return loading;
  }

  /** Compiled module of the last instance. */
  get compiled(): WebAssembly.Module | undefined {
    return this.#compiled;
  }

  /**
   * Discards the instance. Call it after the module broke (out of memory, a trap), since it cannot
   * be used again.
   */
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

/**
 * Compiles a module, while it arrives if the host states the exact content type.
 * @throws the error that prevented fetching
 */
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
