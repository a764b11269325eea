/** The colours of the collection. Every print has three of these colourways, its main one first. */
import type {Ink} from './shape.js';

export type Palette = Readonly<Record<Ink, string>>;

const palette = (
  ground: string,
  line: string,
  leaf: string,
  bloom: string,
  soft: string,
  spark: string,
): Palette => ({ground, line, leaf, bloom, soft, spark});

/** Ground, then line, leaf, bloom, soft and spark. */
export const palettes = {
  linen: palette('#f1eade', '#4f5a48', '#8b9a78', '#c27856', '#cfac7b', '#97503b'),
  mist: palette('#dfe6e8', '#34495f', '#6d879a', '#b96d52', '#9ab0bc', '#dda54c'),
  night: palette('#28364b', '#d5d8c6', '#84997f', '#d79b8b', '#637d9d', '#ecd09a'),
  blush: palette('#f3e3da', '#68464d', '#94906a', '#b1626d', '#d29a8e', '#793a4b'),
  celadon: palette('#dce6da', '#365747', '#6c927b', '#c8953f', '#95b89b', '#a4512f'),
  clay: palette('#ecdaca', '#55443e', '#8a7d59', '#aa573d', '#c99d78', '#dc9c3f'),
  smoke: palette('#e7e4de', '#42474d', '#7b8c90', '#4b7b80', '#a6b1b2', '#c77a57'),
  moss: palette('#3d4637', '#dcd6b8', '#99a278', '#d9936a', '#707c5e', '#f0e4c4'),
  plum: palette('#47323f', '#e3cfc6', '#a3977c', '#cf8088', '#80606f', '#ecc89b'),
} as const satisfies Readonly<Record<string, Palette>>;

export type PaletteName = keyof typeof palettes;
