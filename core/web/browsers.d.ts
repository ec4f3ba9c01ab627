// What browsers and Node 18 have, and TypeScript 4.8 does not know.
interface Array<T> {
    findLast(matches: (value: T, index: number, array: T[]) => unknown): T | undefined;
    findLastIndex(matches: (value: T, index: number, array: T[]) => unknown): number;
}

// esbuild makes them texts.
declare module '*.glsl' { const text: string; export default text; }
declare module '*.vert' { const text: string; export default text; }
declare module '*.frag' { const text: string; export default text; }
declare class DecompressionStream { constructor(format: 'deflate'); readable: ReadableStream<Uint8Array>; writable: WritableStream<Uint8Array>; }
