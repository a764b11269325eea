/** A file by its place, and by the sha256 of its bytes in lower-case hexadecimal digits. */
export interface StoredFile {
  /** http:, https: or file:, or relative to the design. */
  readonly url: string;
  readonly sha256: string;
}
