declare module 'gltf-validator' {
  interface Report {
    readonly issues: {
      readonly numErrors: number;
      readonly numWarnings: number;
      readonly messages: readonly {
        code: string;
        message: string;
        severity: number;
        pointer?: string;
      }[];
    };
    readonly info: {readonly totalVertexCount: number; readonly totalTriangleCount: number};
  }
  export function validateBytes(bytes: Uint8Array, options?: {maxIssues?: number}): Promise<Report>;
}
