/** What is said otherwise to who has a finger and neither mouse nor keys. */
import type {Language} from '../workbench/preferences.js';
import type {Messages} from './messages.js';

export const touch: Readonly<Partial<Record<Language, Messages>>> = {
  en: {
    symmetry: {
      moving: 'Drag the print inside a piece. Tap a piece twice to free it.',
      begin: {
        piece: 'Tap two seam lines of a piece that mirror each other, or two points of its axis.',
        pair: 'Tap the first of two pieces that mirror onto each other.',
      },
      next: {
        line: 'Now tap the line that it mirrors onto, on the same piece.',
        point: 'Now tap a second point on the axis.',
        piece: 'Now tap the piece that it mirrors onto.',
      },
      refusals: {
        sameLine: 'That is the same line again; tap another.',
        samePiece: 'That is the same piece again; tap another.',
        pointAfterLine: 'Tap a second line, or go back and tap two points.',
        unnumbered: 'This line is not known to the file; tap another.',
      },
    },
  },
  de: {
    symmetry: {
      moving: 'Das Muster in einem Teil ziehen. Zweimal auf ein Teil tippen gibt es frei.',
      begin: {
        piece:
          'Zwei Nahtlinien eines Teils antippen, die sich spiegeln, oder zwei Punkte auf seiner Achse.',
        pair: 'Das erste von zwei Teilen antippen, die sich spiegeln.',
      },
      next: {
        line: 'Jetzt die gespiegelte Linie auf demselben Teil antippen.',
        point: 'Jetzt einen zweiten Punkt auf der Achse antippen.',
        piece: 'Jetzt das gespiegelte Teil antippen.',
      },
      refusals: {
        sameLine: 'Das ist noch einmal dieselbe Linie; bitte eine andere antippen.',
        samePiece: 'Das ist noch einmal dasselbe Teil; bitte ein anderes antippen.',
        pointAfterLine: 'Eine zweite Linie antippen, oder zurück und zwei Punkte antippen.',
        unnumbered: 'Diese Linie kennt die Datei nicht; bitte eine andere antippen.',
      },
    },
  },
};
