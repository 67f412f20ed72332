/** Error in a file of photometric data, with its line. */
export class IESError extends Error {
  /** @param line - line of the file, from 1 */
  constructor(
    readonly line: number,
    /** Sentence that says what is wrong, and what to write there. */
    readonly problem: string,
  ) {
    super(`Line ${line}: ${problem}`);
    this.name = 'IESError';
  }
}
