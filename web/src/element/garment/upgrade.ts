/** Properties that a page may have set before the element was defined. */
const properties = [
  ...['garment', 'size', 'print', 'colourway', 'symmetry', 'maxChangeMm', 'view', 'mode'],
  ...[
    'clothWidth',
    'selvedge',
    'loading',
    'units',
    'locale',
    'alt',
    'workerUrl',
    'wasmUrl',
    'messages',
    'prints',
    'name',
  ],
  ...['required', 'disabled', 'value'],
] as const;

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
