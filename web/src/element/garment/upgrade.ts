import {attributes} from './attributes.js';

/** Properties that a page may have set before the element was defined. */
const properties = [
  ...attributes.map((name) =>
    name.replaceAll(/-(.)/g, (_, letter: string) => letter.toUpperCase()),
  ),
  ...['messages', 'prints', 'value'],
];

/**
 * Passes properties that were set before the definition to the element's setters, which they would
 * hide otherwise.
 */
export function upgrade(element: HTMLElement): void {
  for (const name of properties) {
    if (!Object.hasOwn(element, name)) continue;
    const value: unknown = Reflect.get(element, name);
    Reflect.deleteProperty(element, name);
    Reflect.set(element, name, value);
  }
}
