import {describe, expect, it} from 'vitest';

import {readDrawing} from '@/files/read-drawing.js';
import {FileError} from '@/model/base/versioned-file.js';
import {importTexts, saidRefusal} from '@/texts/import-texts.js';

const failureOn = (content: string): FileError => {
  try {
    readDrawing(new TextEncoder().encode(content), 'file.x');
  } catch (error) {
    if (error instanceof FileError) return error;
  }
  throw new Error('no failure');
};

describe('a file that is no pattern', () => {
  it.each([
    ['unreadable', 'garbage'],
    ['empty', ' \n'],
    ['archive', 'PK\u0003\u0004'],
    ['binary', 'AutoCAD Binary DXF'],
    ['binary', 'AC1027'],
    ['illustrator', '%!PS-Adobe-3.0\n%%Creator: Adobe Illustrator(R) 24'],
    ['model', 'glTF'],
    ['model', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n'],
    ['plotter', 'IN;PU0,0;'],
    ['webPage', '<!doctype html>'],
    ['picture', 'GIF89a'],
    ['postScript', '%!PS'],
    ['measurements', '<vit>'],
    ['valentina', '<pattern version="0.8">'],
    ['outline', '<svg xmlns="http://www.w3.org/2000/svg" width="1cm" viewBox="0 0 1 1"/>'],
    ['damaged', '0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nx\n'],
  ] as const)('is said to be %s in German: %j', async (complaint, content) => {
    const words = await importTexts('de');
    const said = saidRefusal(words, failureOn(content), 'file.x');
    expect(said).toBe(words.complaints[complaint]('file.x'));
  });

  it('is described in English otherwise', async () => {
    const words = await importTexts('de');
    const message = 'file.x holds 900 pieces.';
    expect(saidRefusal(words, {message}, 'file.x')).toBe(message);
  });
});
