/** Names in the room that they have. */

/** About how wide a letter of a text is, in parts of its size. */
const letterWidth = 0.56;

export const textWidth = (content: string, size: number): number =>
  letterWidth * size * content.length;

/** A name as it is shown, in lines no wider than `room` where its words allow it. [px] */
export function nameLines(name: string, room: number, size: number): readonly string[] {
  const lines: string[] = [];
  for (const word of name.replaceAll('_', ' ').split(' ')) {
    const longer = [...lines.slice(-1), word].join(' ');
    if (lines.length > 0 && textWidth(longer, size) <= room) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
