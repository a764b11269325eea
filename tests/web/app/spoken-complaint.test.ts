import {describe, expect, it} from 'vitest';

import {spokenComplaint} from '@/app/import/spoken-complaint.js';
import {readDrawing} from '@/files/read-drawing.js';
import {importTexts} from '@/texts/import-texts.js';

const complaintOn = (content: string): string => {
  try {
    readDrawing(new TextEncoder().encode(content), 'file.x');
  } catch (error) {
    return (error as Error).message;
  }
  return 'read';
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
    ['valentina', '<pattern version="0.8">'],
    ['outline', '<svg xmlns="http://www.w3.org/2000/svg" width="1cm" viewBox="0 0 1 1"/>'],
    ['damaged', '0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nx\n'],
  ] as const)('is said to be %s in German: %j', async (complaint, content) => {
    const words = await importTexts('de');
    const said = spokenComplaint(complaintOn(content), 'file.x', words);
    expect(said).toBe(words.complaints[complaint]('file.x'));
  });

  it('is described in English otherwise', async () => {
    const words = await importTexts('de');
    const message = 'file.x holds 900 pieces.';
    expect(spokenComplaint(message, 'file.x', words)).toBe(words.failed(message));
  });
});
