/** Fourier transforms of square images whose sides are powers of two. */

export interface Spectrum {
  readonly n: number;
  readonly re: Float64Array;
  readonly im: Float64Array;
}

function transformLine(re: Float64Array, im: Float64Array, sign: number): void {
  const n = re.length;
  for (let i = 1, j = 0; i < n; i++) {
    let bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) {
      [re[i], re[j]] = [re[j] ?? 0, re[i] ?? 0];
      [im[i], im[j]] = [im[j] ?? 0, im[i] ?? 0];
    }
  }
  for (let size = 2; size <= n; size *= 2) {
    const half = size / 2;
    for (let k = 0; k < half; k++) {
      const angle = (sign * 2 * Math.PI * k) / size;
      const c = Math.cos(angle);
      const s = Math.sin(angle);
      for (let i = k; i < n; i += size) {
        const x = re[i + half] ?? 0;
        const y = im[i + half] ?? 0;
        const tx = x * c - y * s;
        const ty = x * s + y * c;
        const ox = re[i] ?? 0;
        const oy = im[i] ?? 0;
        re[i + half] = ox - tx;
        im[i + half] = oy - ty;
        re[i] = ox + tx;
        im[i] = oy + ty;
      }
    }
  }
}

/** Transforms in place, unscaled. @param sign  -1 to frequencies, 1 back */
export function transform({n, re, im}: Spectrum, sign: -1 | 1): void {
  const lineRe = new Float64Array(n);
  const lineIm = new Float64Array(n);
  const along = (start: number, step: number): void => {
    for (let i = 0; i < n; i++) {
      lineRe[i] = re[start + i * step] ?? 0;
      lineIm[i] = im[start + i * step] ?? 0;
    }
    transformLine(lineRe, lineIm, sign);
    for (let i = 0; i < n; i++) {
      re[start + i * step] = lineRe[i] ?? 0;
      im[start + i * step] = lineIm[i] ?? 0;
    }
  };
  for (let j = 0; j < n; j++) along(j * n, 1);
  for (let i = 0; i < n; i++) along(i, n);
}
