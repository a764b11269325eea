/** Decodes the characters of a DXF file. */
import {decoded} from '../base/decoded.js';

/** Code pages of `$DWGCODEPAGE`, and of programs with their own encoding. */
const codePages: readonly (readonly [RegExp, string])[] = [
  [/ANSI_936\b|RICHPEACE/i, 'gb18030'],
  [/ANSI_950\b/i, 'big5'],
  [/ANSI_932\b/i, 'shift_jis'],
  [/ANSI_949\b/i, 'euc-kr'],
  [/ANSI_1251\b/i, 'windows-1251'],
  [/ANSI_1250\b/i, 'windows-1250'],
  [/ANSI_1254\b/i, 'windows-1254'],
];

/** Decodes UTF-8 or UTF-16 if valid, otherwise by the file's code page, otherwise Latin-1. */
export function textOf(bytes: Uint8Array): string {
  if (bytes[0] === 0xff || bytes[0] === 0xfe) return decoded(bytes);
  try {
    return new TextDecoder('utf-8', {fatal: true}).decode(bytes);
  } catch {
    const latin = new TextDecoder('windows-1252').decode(bytes);
    const [, page] = codePages.find(([pattern]) => pattern.test(latin)) ?? [];
    return page === undefined ? latin : new TextDecoder(page).decode(bytes);
  }
}

/** The text without formatting codes. */
export const plainText = (text: string): string =>
  text
    .replaceAll(/\\U\+([0-9a-f]{4})/gi, (_, digits: string) =>
      String.fromCharCode(parseInt(digits, 16)),
    )
    .replaceAll(/\\P/g, ' ')
    .replaceAll(/\\[ACFHQTWfp][^;]{0,100};|[{}]/g, '')
    .trim();
