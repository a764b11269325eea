/** Lists of whole numbers as people write them: "1, 3-5". */

/** Writes numbers, consecutive ones as ranges, in their order. */
export function rangesOf(numbers: readonly number[]): string {
  const parts: string[] = [];
  for (let k = 0; k < numbers.length;) {
    let end = k;
    while (numbers[end + 1] === (numbers[end] ?? 0) + 1) end++;
    const [first = 0, last = 0] = [numbers[k], numbers[end]];
    parts.push(end === k ? String(first) : `${first}-${last}`);
    k = end + 1;
  }
  return parts.join(', ');
}

/** Greatest number in a list. */
const most = 5000;

/** The numbers of a list, from 1, each once and in its order; undefined for any other text. */
export function numbersIn(text: string): readonly number[] | undefined {
  const numbers = text.split(/[,;]/).flatMap((part): readonly number[] => {
    const [, from, to = from] = /^\s*(\d{1,4})(?:\s*[-–]\s*(\d{1,4}))?\s*$/.exec(part) ?? [];
    const [first, last] = [Number(from), Number(to)];
    const isRange = first >= 1 && last >= first && last <= most;
    return isRange ? Array.from({length: last - first + 1}, (_, k) => first + k) : [NaN];
  });
  return numbers.every(Number.isFinite) ? [...new Set(numbers)] : undefined;
}
