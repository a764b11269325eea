/** Decodes the characters of a DXF file. */
import {decoded} from '../base/decoded.js';
import {dosText} from './dos-text.js';

/** Encodings by code page, as `$DWGCODEPAGE` names them. */
const encodings: Readonly<Record<string, string>> = {
  ...{874: 'windows-874', 932: 'shift_jis', 936: 'gb18030', 949: 'euc-kr', 950: 'big5'},
  ...{866: 'ibm866', 1361: 'euc-kr', 10000: 'macintosh', 65001: 'utf-8'},
  ...Object.fromEntries(Array.from({length: 9}, (_, k) => [`${1250 + k}`, `windows-${1250 + k}`])),
  ...Object.fromEntries(Array.from({length: 9}, (_, k) => [`8859_${k + 1}`, `iso-8859-${k + 1}`])),
};

/** Decodes UTF-8 or UTF-16 if valid, otherwise by the file's code page, otherwise Latin-1. */
export function textOf(bytes: Uint8Array): string {
  if (bytes[0] === 0xff || bytes[0] === 0xfe) return decoded(bytes);
  try {
    return new TextDecoder('utf-8', {fatal: true}).decode(bytes);
  } catch {
    const latin = new TextDecoder('windows-1252').decode(bytes);
    const said = /\$DWGCODEPAGE\s+3\s+(\S+)/i.exec(latin.slice(0, 20_000))?.[1];
    const page = /RICHPEACE/i.test(latin) ? '936' : pageOf(said);
    if (page === undefined) return latin;
    const encoding = encodings[page];
    return encoding === undefined ? dosText(bytes, page) : new TextDecoder(encoding).decode(bytes);
  }
}

/** The number in the name of a code page, such as `ANSI_1253`, `dos850` or `iso8859-7`. */
const pageOf = (name: string | undefined): string | undefined =>
  /mac(?:intosh)?/i.test(name ?? '')
    ? '10000'
    : (/8859[-_]?\d/.exec(name ?? '')?.[0].replace(/8859[-_]?/, '8859_') ??
      (/johab/i.test(name ?? '') ? '1361' : /\d{3,5}/.exec(name ?? '')?.[0]));

/**
 * The text without formatting codes: those of MTEXT after a backslash, and those of TEXT after two
 * per cent signs.
 */
export const plainText = (text: string): string =>
  text
    .replaceAll(/\\U\+([0-9a-f]{4})/gi, (_, digits: string) =>
      String.fromCharCode(parseInt(digits, 16)),
    )
    .replaceAll(/\\M\+[0-9a-f]{5}/gi, '')
    .replaceAll(/%%(\d{3})/g, (_, digits: string) => String.fromCharCode(Number(digits)))
    .replaceAll(/%%([a-z%])/gi, (_, code: string) => signs[code.toLowerCase()] ?? '')
    .replaceAll(/\\[PNX~]/g, ' ')
    .replaceAll(/\\S([^;^/#]{0,50})[\^/#]([^;]{0,50});/g, '$1/$2')
    .replaceAll(/\\[ACFHQTWfpc][^;\\]{0,100};/g, '')
    .replaceAll(/\\[LlOoKk]|(?<!\\)[{}]/g, '')
    .replaceAll(/\\([\\{}])/g, '$1')
    .replaceAll(/\s+/g, ' ')
    .trim();

/** Signs by the letter after two per cent signs; other letters underline, overline or strike out. */
const signs: Readonly<Record<string, string>> = {'%': '%', d: '°', p: '±', c: '⌀'};
