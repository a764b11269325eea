/** What a worker of one question says: its answer or why there is none, and before that what it needs to know. */
export type Reply =
  | {readonly kind: 'answer'; readonly answer: unknown}
  | {readonly kind: 'failed'; readonly message: string}
  | {readonly kind: 'request'; readonly request: unknown};
