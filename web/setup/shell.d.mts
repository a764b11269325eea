/** The command that runs a program of an installed npm package, on every platform. */
export function tool(name: string, program?: string): [node: string, script: string];

/** Returns whether a program of that name exists. */
export function has(command: string): boolean;
