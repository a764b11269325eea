/** A file by its URL, and by the sha256 of its bytes in lower-case hexadecimal digits. */
export interface StoredFile {
  /** An http:, https: or file: URL, or a path relative to the design. */
  readonly url: string;
  readonly sha256: string;
}
