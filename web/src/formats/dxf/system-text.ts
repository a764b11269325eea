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
 * Parses a quantity: "1,1" means as drawn and mirrored, "2" as drawn. Decimals are ignored, since
 * some programs write integers with them.
 */
export function quantityOf(text: string | undefined): {asDrawn: number; mirrored: number} {
  const [, first = '1', second = '0'] =
    /^\s*(\d{1,4})(?:\s*[,;/]\s*(\d{1,4}))?/.exec(text ?? '') ?? [];
  const [asDrawn, mirrored] = [Number(first), Number(second)];
  return asDrawn + mirrored === 0 ? {asDrawn: 1, mirrored: 0} : {asDrawn, mirrored};
}
