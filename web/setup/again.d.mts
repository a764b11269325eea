export function again(
  work: () => Promise<void> | void,
  told: (error: unknown) => void,
  quiet?: number,
): () => void;
