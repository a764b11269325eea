/**
 * Sends one request to a separate worker, which ends after its answer; the page stays responsive,
 * and no memory is kept.
 */
import type {Failure} from '../../model/base/failure.js';
import type {Reply} from './serve.js';

/** Reason for a missing answer, in one sentence. */
export class WorkerComplaint extends Error {
  override readonly name = 'WorkerComplaint';

  constructor(
    message: string,
    /** The reason, if the failure has one. */
    readonly reason?: Failure['reason'],
  ) {
    super(message);
  }
}

/**
 * Sends a request to a worker.
 * @param help answers requests of the worker meanwhile
 * @throws {WorkerComplaint} if the request fails; the signal's reason when it fires
 */
export async function ask<Answer>(
  worker: Worker,
  question: unknown,
  signal: AbortSignal,
  help?: (request: unknown) => Promise<unknown>,
): Promise<Answer> {
  const answered = async (request: unknown): Promise<void> => {
    worker.postMessage(await help?.(request));
  };
  try {
    return await new Promise<Answer>((resolve, reject) => {
      signal.throwIfAborted();
      worker.onmessage = ({data}: MessageEvent<Reply>) => {
        if (data.kind === 'answer') resolve(data.answer as Answer);
        else if (data.kind === 'failed') reject(new WorkerComplaint(data.message, data.reason));
        else void answered(data.request).catch(reject);
      };
      worker.onerror = ({message}) => {
        reject(new WorkerComplaint(message));
      };
      signal.addEventListener('abort', () => {
        reject(signal.reason as Error);
      });
      worker.postMessage(question);
    });
  } finally {
    worker.terminate();
  }
}
