/** The words that run a program of an installed npm package, on every platform. */
export function tool(name: string, program?: string): [node: string, script: string];

/** Whether there is a program of that name. */
export function has(command: string): boolean;
