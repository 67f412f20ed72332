/** Error in a photometric file, with its line. */
export class IESError extends Error {
  /** @param line - line of the file, from 1 */
  constructor(
    readonly line: number,
    /** Sentence on what is wrong, and what to write instead. */
    readonly problem: string,
  ) {
    super(`Line ${line}: ${problem}`);
    this.name = 'IESError';
  }
}
