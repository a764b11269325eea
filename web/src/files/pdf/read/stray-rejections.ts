/**
 * In damaged files, pdf.js rejects promises that nobody awaits, which would end a Node process. The
 * same errors also reach the awaited promises.
 */
interface NodeProcess {
  on(event: 'unhandledRejection', listener: (reason: unknown) => void): void;
  off(event: 'unhandledRejection', listener: (reason: unknown) => void): void;
}

/** Errors of the parser of pdf.js by name. */
const parserErrors =
  /^(?:XRef\w*|ParserEOF|Format|MissingData|Unknown\w*|Abort)(?:Exception|Error)$/;

/** Ignores unawaited errors of the parser during some work in Node. Browsers only log them. */
export async function ignoringStrayRejections<T>(work: () => Promise<T>): Promise<T> {
  const {process} = globalThis as {readonly process?: Partial<NodeProcess>};
  const ignore = (reason: unknown): void => {
    if (!parserErrors.test((reason as Error | undefined)?.name ?? '')) throw reason;
  };
  process?.on?.('unhandledRejection', ignore);
  try {
    return await work();
  } finally {
    // Node reports them after the current task
    await new Promise((resolve) => setTimeout(resolve));
    process?.off?.('unhandledRejection', ignore);
  }
}
