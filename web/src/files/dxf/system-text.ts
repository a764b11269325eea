/** Parses the system text "Identifier: value" of styles and pieces in AAMA and ASTM files. */
import type {TextEntity} from './entities.js';

export interface SystemText {
  /** The value of an identifier, regardless of case; undefined if missing or empty. */
  readonly value: (identifier: string) => string | undefined;
  /** All values of an identifier. */
  readonly all: (identifier: string) => readonly string[];
  /** Text that is no system text. */
  readonly others: readonly TextEntity[];
}

const pattern = /^\s*([a-z][\w ./]{0,40}?)\s*:\s*(.*?)\s*$/i;

export function systemText(texts: readonly TextEntity[]): SystemText {
  const values = new Map<string, string[]>();
  const others: TextEntity[] = [];
  for (const entity of texts) {
    const [, identifier, value = ''] = pattern.exec(entity.text) ?? [];
    if (identifier === undefined) others.push(entity);
    else if (value !== '') {
      const key = identifier.toLowerCase();
      values.set(key, [...(values.get(key) ?? []), value]);
    }
  }
  const all = (identifier: string): readonly string[] => values.get(identifier.toLowerCase()) ?? [];
  return {value: (identifier) => all(identifier)[0], all, others};
}

/**
 * Parses a quantity: "1,1" means one as drawn and one mirrored, "2,0" two alike, and "2" alone a
 * pair. Decimals are ignored, since some programs write integers with them. Undefined without a
 * quantity.
 */
export function quantityOf(
  text: string | undefined,
): {readonly asDrawn: number; readonly mirrored: number} | undefined {
  const [, first, second] = /^\s*(\d{1,4})(?:\s*[,;/]\s*(\d{1,4}))?/.exec(text ?? '') ?? [];
  if (first === undefined) return undefined;
  if (second === undefined && Number(first) === 2) return {asDrawn: 1, mirrored: 1};
  return {asDrawn: Number(first), mirrored: Number(second ?? '0')};
}
