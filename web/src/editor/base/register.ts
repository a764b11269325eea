/** Registers a part, unless that is done already: two who use the parts on one page do not get in each other's way. */
export function register(name: string, part: CustomElementConstructor): void {
  if (!customElements.get(name)) customElements.define(name, part);
}

/** Registers parts by their names. */
export function registerAll(parts: Readonly<Record<string, CustomElementConstructor>>): void {
  for (const [name, part] of Object.entries(parts)) register(name, part);
}
