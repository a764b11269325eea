/** Colours of the garments on a fabric, in their order. */
import {css} from 'lit';

/** Number of different colours; further garments begin again, and differ by their letters. */
const count = 8;

/** Class of a garment's colour. */
export const colourClass = (which: number): string => `of-${which % count}`;

/** `--garment` is the colour of an element with such a class. */
export const garmentColours = css`
  .of-0 {
    --garment: #2a65ad;
  }
  .of-1 {
    --garment: #b3501a;
  }
  .of-2 {
    --garment: #2b7a4b;
  }
  .of-3 {
    --garment: #883b8d;
  }
  .of-4 {
    --garment: #7d6400;
  }
  .of-5 {
    --garment: #ad3063;
  }
  .of-6 {
    --garment: #2f757c;
  }
  .of-7 {
    --garment: #57514a;
  }
`;
