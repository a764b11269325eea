import {describe, expect, it} from 'vitest';

import {readDrawing} from '@/files/read-drawing.js';
import {FileError} from '@/model/base/versioned-file.js';

import {bodice, millimetreSheet, stroked, svg, words} from '../../support/files/drawn-svg.js';

const bytesOf = (text: string): Uint8Array =>
  Uint8Array.from(text, (letter) => letter.charCodeAt(0));

/** The error for a file, without its name. */
function refusal(content: string | Uint8Array): string {
  const bytes = typeof content === 'string' ? bytesOf(content) : content;
  const start = process.cpuUsage();
  try {
    readDrawing(bytes, 'FILE');
  } catch (error) {
    if (!(error instanceof FileError)) throw error;
    expect(process.cpuUsage(start).user / 1e6).toBeLessThan(2);
    const [, sentence = ''] = /^FILE (.*)$/s.exec(error.message) ?? [];
    // one sentence: it ends once
    expect(sentence).toMatch(/^[^\n]+[.]$/);
    return sentence;
  }
  return 'is read';
}

describe('files of other kinds', () => {
  it.each([
    ['a binary DXF', 'AutoCAD Binary DXF\r\n\x1a\0', /ASCII DXF/],
    ['DWG', 'AC1032\0\0\0\0', /DWG.*ASCII DXF/],
    ['a picture called .dxf', '\x89PNG\r\n\x1a\n\0\0\0\rIHDR', /PNG picture.*DXF or SVG/],
    ['a photo', '\xff\xd8\xff\xe0', /JPEG picture/],
    ['old Illustrator', '%!PS-Adobe-3.0\n%%Creator: Adobe Illustrator(R) 8', /Save a Copy.*SVG/],
    ['EPS', '%!PS-Adobe-3.0 EPSF-3.0', /PostScript.*Inkscape/],
    ['a project of CLO', 'PK\x03\x04\x14\0', /\.zprj.*File > Export > DXF \(AAMA\/ASTM\)/],
    ['a compressed SVG', '\x1f\x8b\x08\0', /plain SVG/],
    ['a film of a garment', 'glTF\x02\0\0\0', /OBJ with UVs/],
    ['STL', 'solid tee\n facet normal 0 0 1\n', /OBJ with UVs/],
    ['a plotter file', 'IN;SP1;PU0,0;PD100,100;', /HP-GL/],
    ['a web page', '<!DOCTYPE html>\n<html><svg></svg></html>', /web page/],
    [
      'a pattern of Valentina',
      '<?xml version="1.0"?>\n<pattern><!--Valentina pattern format.--><unit>cm</unit></pattern>',
      /File > Export layout.*valentina -b NAME -f 25 FILE\.val/,
    ],
    [
      'measurements of Valentina',
      '<?xml version="1.0"?>\n<vit><unit>cm</unit></vit>',
      /measurements/,
    ],
    ['words', 'Dear Sir or Madam', /no pattern/],
    ['nothing', '', /^is empty; export it again/],
    ['blank lines', '\r\n  \r\n', /^is empty; export it again/],
  ])('are told what to do: %s', (_, content, said) => {
    expect(refusal(content)).toMatch(said);
  });
});

describe('damaged and hostile SVG', () => {
  const bomb = [
    '<!ENTITY a "aaaa">',
    ...'bcdef'
      .split('')
      .map((name, k) => `<!ENTITY ${name} "${`&${'abcde'.charAt(k)};`.repeat(10)}">`),
  ];

  it.each([
    [
      'with entities of its own',
      `<!DOCTYPE svg [${bomb.join('')}]>${svg(millimetreSheet, '<text>&f;</text>')}`,
      /entity '&f;'.*plain SVG/,
    ],
    [
      'that reads other files',
      `<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]>${svg('', '<text>&x;</text>')}`,
      /entity '&x;'/,
    ],
    [
      'that is cut short',
      svg(millimetreSheet, stroked(bodice())).slice(0, -20),
      /damaged near line \d+, or cut short.*export it again/,
    ],
    ['with tags that cross', svg('', '<g><a></g></a>'), /<\/g> closes <a>/],
    ['with an attribute without its end', svg('', '<path d="M0 0>'), /damaged near line/],
    [
      'nested too deep',
      svg('', '<g>'.repeat(70) + '</g>'.repeat(70)),
      /more than 64 deep.*ungroup/,
    ],
    [
      'without width',
      svg('width="0" height="10mm"', stroked(bodice())),
      /size of '0'.*correct its width/,
    ],
    [
      'that flattens',
      svg(millimetreSheet, `<g transform="scale(1, 0)">${stroked(bodice(), 'id="front"')}</g>`),
      /flattens 'front'/,
    ],
    [
      'with a transform that is none',
      svg(millimetreSheet, `<g transform="rotate(1,2">${stroked(bodice())}</g>`),
      /transform that cannot be read/,
    ],
    [
      'with endless numbers',
      svg(millimetreSheet, stroked('M 0 0 L 1e300 0 L 1e300 1e300 z', 'id="x"')),
      /'x' more than 100 m away/,
    ],
    [
      'of words alone',
      svg(millimetreSheet, words(10, 10, 'Front')),
      /text alone.*export the outlines/,
    ],
    ['of nothing', svg(millimetreSheet), /no closed line/],
    [
      'of small things',
      svg(millimetreSheet, stroked('M 0 0 h 10 v 7 h -10 z')),
      /largest closed line is 1\.0 cm/,
    ],
    [
      'with an outline that is open',
      svg(
        millimetreSheet,
        stroked(
          bodice(1, [20, 30])
            .replace('40,60 0,60 z', '40,60 3,60')
            .replace('60,90 20,90 z', '60,90 23,90'),
        ),
      ),
      /3\.0 mm apart at x 2\.0 cm, y 9\.0 cm.*join them/,
    ],
    [
      'that uses itself',
      svg(millimetreSheet, `<g id="a"><use href="#a"/>${stroked(bodice())}</g>`),
      /'a' within itself/,
    ],
    [
      'of too many shapes',
      svg(millimetreSheet, '<path d="M0 0h1v1z"/>'.repeat(61_000)),
      /more than 60000 elements/,
    ],
    [
      'of too many uses',
      svg(
        millimetreSheet,
        `<defs><g id="g0">${stroked('M0 0h1')}</g>${Array.from({length: 14}, (_, k) => `<g id="g${k + 1}">${`<use href="#g${k}"/>`.repeat(10)}</g>`).join('')}</defs><use href="#g14"/>`,
      ),
      /more than 60000 shapes/,
    ],
    [
      'of too many outlines',
      svg(
        'width="99999mm" height="99mm" viewBox="0 0 99999 99"',
        ...Array.from({length: 1500}, (_, k) => stroked(`M ${60 * k} 0 h 55 v 55 h -55 z`)),
      ),
      /1500 closed lines.*delete/,
    ],
    [
      'with a path of too many points',
      svg(millimetreSheet, stroked(`M 0 0 ${'L 1 1 L 9 300 '.repeat(30_000)}`, 'id="x"')),
      /'x' through more points.*simplify/,
    ],
    ['that is other XML', '<kml><svg></svg></kml>', /no SVG.*<kml>/],
  ])('is refused with one sentence: %s', (_, content, said) => {
    expect(refusal(content)).toMatch(said);
  });

  it('is read past what it does not need: scripts, pictures, uses of other files, broken paths', () => {
    const text = svg(
      `${millimetreSheet} onload="alert(1)"`,
      '<script>while (true) {}</script>',
      '<image href="https://example.org/x.png" width="10" height="10"/>',
      '<use href="other.svg#front"/>',
      stroked('M 300 0 L 310 0 L 310 NaN', 'id="broken"'),
      stroked(bodice()),
    );
    const {pieces, notes} = readDrawing(bytesOf(text), 'FILE');
    expect(pieces).toHaveLength(1);
    expect(notes).toEqual([
      'Scripts in the file are not run.',
      'Pictures in the file are left out.',
      "What is used from 'other.svg#front' is not in the file, and left out.",
      "The path 'broken' is damaged, and read as far as it goes.",
    ]);
  });

  it('may declare entities for its namespaces, as Illustrator does, and be in UTF-16', () => {
    const text = `<?xml version="1.0"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://x" [<!ENTITY ns_svg "http://www.w3.org/2000/svg">]>${svg(`${millimetreSheet} xmlns:x="&ns_svg;"`, stroked(bodice()), '<text x="99" y="99">R&#252;cken &amp; &#x41;</text>')}`;
    expect(readDrawing(bytesOf(text), 'FILE').pieces[0]?.name).toBe('Rücken & A');
    const marked = `\ufeff${text}`;
    const twice = new Uint8Array(2 * marked.length);
    for (let k = 0; k < marked.length; k++) {
      new DataView(twice.buffer).setUint16(2 * k, marked.charCodeAt(k), true);
    }
    expect(readDrawing(twice, 'FILE').pieces).toHaveLength(1);
  });
});

describe('damaged and hostile OBJ', () => {
  const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';
  const flat = 'vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n';

  it.each([
    [
      'without texture coordinates',
      `${square}f 1 2 3 4\n`,
      /no texture coordinates \(vt\).*with UVs/,
    ],
    ['with normals alone', `${square}vn 0 0 1\nf 1//1 2//1 3//1\n`, /no texture coordinates/],
    [
      'with texture coordinates outside its faces',
      `${square}${flat}f 1 2 3 4\n`,
      /no face names.*f v\/vt/,
    ],
    ['without faces', `${square}${flat}`, /no faces/],
    [
      'that names what is not there',
      `${square}${flat}f 1/1 2/2 9/3\n`,
      /vertex 9, of which there are 4/,
    ],
    ['that counts back too far', `${square}${flat}f -5/1 2/2 3/3\n`, /vertex -5/],
    [
      'with numbers that are none',
      `v 0 0 zero\n${flat}f 1/1 1/2 1/3\n`,
      /'zero' where a number should be \(line 1\)/,
    ],
    ['with NaN', `v 0 0 NaN\n${flat}f 1/1 1/2 1/3\n`, /'NaN'/],
    [
      'with three faces at an edge',
      `${square}v 0 0 1\n${flat}vt 0 -1\nvt .5 -1\nf 1/1 2/2 3/3\nf 2/2 1/1 4/5\nf 2/2 1/1 5/6\n`,
      /more than two faces meet.*remove doubles/,
    ],
    [
      'with faces turned over',
      `${square}${flat}f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 1/1 2/2 4/4\n`,
      /turned over/,
    ],
  ])('is refused with one sentence: %s', (_, content, said) => {
    expect(refusal(content)).toMatch(said);
  });

  it('of more than half a million triangles is refused', () => {
    const faces = 'f 1/1 2/2 3/3\n'.repeat(500_001);
    expect(refusal(`${square}${flat}${faces}`)).toMatch(/more than 500000 triangles.*coarser/);
  });

  it('of two hundred thousand triangles is read in seconds', () => {
    const side = 317;
    const lines: string[] = [];
    for (let y = 0; y < side; y++)
      for (let x = 0; x < side; x++) lines.push(`v ${x} ${y} 0`, `vt ${x} ${y}`);
    for (let y = 1; y < side; y++) {
      for (let x = 1; x < side; x++) {
        const [a, b] = [(y - 1) * side + x, y * side + x];
        lines.push(`f ${a}/${a} ${a + 1}/${a + 1} ${b + 1}/${b + 1} ${b}/${b}`);
      }
    }
    const bytes = bytesOf(lines.join('\n'));
    const start = process.cpuUsage();
    const {pieces} = readDrawing(bytes, 'FILE');
    expect(pieces).toHaveLength(1);
    expect(pieces[0]?.sewn).toHaveLength(4);
    expect(process.cpuUsage(start).user / 1e6).toBeLessThan(2);
  });
});
