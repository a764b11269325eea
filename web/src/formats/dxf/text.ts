/** The characters of a DXF file, whichever encoding wrote them. */
import {decoded} from '../base/decoded.js';

/** Of `$DWGCODEPAGE`, and of programs that write their own. */
const codePages: readonly (readonly [RegExp, string])[] = [
  [/ANSI_936\b|RICHPEACE/i, 'gb18030'],
  [/ANSI_950\b/i, 'big5'],
  [/ANSI_932\b/i, 'shift_jis'],
  [/ANSI_949\b/i, 'euc-kr'],
  [/ANSI_1251\b/i, 'windows-1251'],
  [/ANSI_1250\b/i, 'windows-1250'],
  [/ANSI_1254\b/i, 'windows-1254'],
];

/** UTF-8 or UTF-16 where it is such, else what the file says of itself, else Latin-1. */
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

/** What stands in a text, without the marks that lay it out. */
export const plainText = (text: string): string =>
  text
    .replaceAll(/\\U\+([0-9a-f]{4})/gi, (_, digits: string) =>
      String.fromCharCode(parseInt(digits, 16)),
    )
    .replaceAll(/\\P/g, ' ')
    .replaceAll(/\\[ACFHQTWfp][^;]{0,100};|[{}]/g, '')
    .trim();
