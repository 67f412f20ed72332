/** What is wrong with a file of photometric data, and where. */
export class IESError extends Error {
  /** @param line - of the file, from 1 */
  constructor(
    readonly line: number,
    /** What is wrong, and what to write there. */
    readonly problem: string,
  ) {
    super(`Line ${line}: ${problem}`);
    this.name = 'IESError';
  }
}
