/** `best`: the default; `paper`: Wolff et al., VMV 2019; `ws19`: the method that paper extends. */
export const methods = ['best', 'paper', 'ws19'] as const;

export type Method = (typeof methods)[number];
