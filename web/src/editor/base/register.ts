/** Registers a custom element unless its name is taken, so that a page may load the parts twice. */
export function register(name: string, part: CustomElementConstructor): void {
  if (!customElements.get(name)) customElements.define(name, part);
}

/** Registers custom elements by tag name. */
export function registerAll(parts: Readonly<Record<string, CustomElementConstructor>>): void {
  for (const [name, part] of Object.entries(parts)) register(name, part);
}
