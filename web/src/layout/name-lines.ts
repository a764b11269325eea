/** Breaks names into lines. */

/** Approximate width of a letter, as a share of the font size. */
const letterWidth = 0.56;

export const textWidth = (content: string, size: number): number =>
  letterWidth * size * content.length;

/** A displayed name in lines no wider than `room`, if its words permit. [px] */
export function nameLines(name: string, room: number, size: number): readonly string[] {
  const lines: string[] = [];
  for (const word of name.replaceAll('_', ' ').split(' ')) {
    const longer = [...lines.slice(-1), word].join(' ');
    if (lines.length > 0 && textWidth(longer, size) <= room) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
