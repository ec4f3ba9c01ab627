// What browsers and Node 18 have, and TypeScript 4.8 does not know.
interface Array<T> {
    findLast(matches: (value: T, index: number, array: T[]) => unknown): T | undefined;
    findLastIndex(matches: (value: T, index: number, array: T[]) => unknown): number;
}
