/** The amount of the print that a cutting sheet shows. */
export const printInks = ['full', 'pale', 'outline'] as const;

/** `full`: as on the fabric; `pale`: tinted, to save ink; `outline`: lines only. */
export type PrintInk = (typeof printInks)[number];

/** Share of white over a pale print. It keeps motifs recognisable at a third of the ink. */
export const paleWhite = 0.68;
