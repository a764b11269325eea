/** Letters that the embedded font does not have, from fonts or as pictures. */
import type {TrueType} from './true-type.js';

/** A font and its name in files, without blanks. */
export interface NamedFont {
  readonly name: string;
  readonly font: TrueType;
}

/** Letters in black, one bit a pixel; rows start at bytes, 1 is ink. */
export interface LettersPicture {
  readonly width: number;
  readonly height: number;
  readonly bits: Uint8Array<ArrayBuffer>;
  /** Pixels per font size, and from the top to the baseline. */
  readonly perEm: number;
  readonly baseline: number;
}

/** Sources of letters; a picture precedes fonts. */
export interface OtherLetters {
  readonly pictureOf?: (text: string) => LettersPicture | undefined;
  /** A font with the letter; the same object for letters of the same font. */
  readonly fontFor?: (letter: string) => Promise<NamedFont | undefined>;
}
