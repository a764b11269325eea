/**
 * Names of the samples, which are in English in their files: garments by style, prints and
 * colourways by name, pieces and seams by their English name without the side (`sample-names.ts`).
 */

type Names = Readonly<Partial<Record<string, string>>>;

export const samples = {
  samples: {garments: {}, prints: {}, colourways: {}, pieces: {}, seams: {}} as Readonly<
    Record<'garments' | 'prints' | 'colourways' | 'pieces' | 'seams', Names>
  >,
};
