/** What may have been set before the element was known. */
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

/** Properties that were set then hide those of the element: they are handed to these. */
export function upgrade(element: HTMLElement): void {
  for (const name of properties) {
    if (!Object.hasOwn(element, name)) continue;
    const value: unknown = Reflect.get(element, name);
    Reflect.deleteProperty(element, name);
    Reflect.set(element, name, value);
  }
}
