/** Custom messages of pages that embed the element. */
import type {Texts} from './en.js';
import type {DrapeTexts} from './en/drape.js';
import type {FoldTexts} from './en/fold.js';
import type {MarkerTexts} from './en/marker.js';
import type {PhotoTexts} from './en/photo.js';
import type {SewTexts} from './en/sew.js';

type Some<T> = T extends (...given: never) => string
  ? T | string
  : T extends string
    ? string
    : T extends readonly unknown[]
      ? T
      : {readonly [Name in keyof T]?: Some<T[Name]>};

/**
 * Any of the texts, by their names in `texts/en`. A plain sentence may replace one with figures.
 */
export type Messages = Some<
  Texts & {worn: DrapeTexts; sew: SewTexts; fold: FoldTexts; cloth: MarkerTexts; photo: PhotoTexts}
>;

/** Merges messages into the texts. Messages of another type than their text are ignored. */
export const withMessages = <T>(texts: T, messages: Messages): T => merged(texts, messages) as T;

function merged(own: unknown, given: unknown): unknown {
  switch (typeof own) {
    case 'string':
      return typeof given === 'string' ? given : own;
    case 'function':
      if (typeof given === 'string') return () => given;
      return typeof given === 'function' ? given : own;
    default: {
      if (typeof given !== 'object' || given === null || Array.isArray(own)) return own;
      const words = Object.entries(own as Record<string, unknown>);
      return Object.fromEntries(
        words.map(([name, word]) => [name, merged(word, Reflect.get(given, name))]),
      );
    }
  }
}
