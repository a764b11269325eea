/**
 * Messages of a worker for one request: its answer or its error, and before that its own requests.
 */
export type Reply =
  | {readonly kind: 'answer'; readonly answer: unknown}
  | {readonly kind: 'failed'; readonly message: string}
  | {readonly kind: 'request'; readonly request: unknown};
