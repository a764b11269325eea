/** Registers a part, unless that is done already: two who use the parts on one page do not get in each other's way. */
export function register(name: string, part: CustomElementConstructor): void {
  if (!customElements.get(name)) customElements.define(name, part);
}
