export function configure(
  preset: string,
  flags?: readonly string[],
  project?: string,
): Promise<boolean>;
export function forgetMoved(folder: string, project: string): boolean;
