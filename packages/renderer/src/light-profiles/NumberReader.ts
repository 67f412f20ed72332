import { IESError } from './IESError';

/** Longest piece of a file that a message quotes (characters). */
const QUOTED = 20;

/** Reads the numbers of a photometric file one by one, across line breaks. */
export class NumberReader {
  /** Line of the last number read, from 1. */
  line: number;
  private words: string[] = [];
  private word = 0;

  /** @param next - index of the first line with numbers */
  constructor(
    private readonly lines: readonly string[],
    private next: number,
  ) {
    this.line = next + 1;
  }

  /**
   * The next number.
   * @param what - meaning of the number, for the message, such as 'the number of lamps'
   * @throws IESError when there is none
   */
  number(what: string): number {
    while (this.word >= this.words.length) {
      if (this.next >= this.lines.length) {
        throw new IESError(this.lines.length, `the file ends before ${what}; get a complete copy of the file.`);
      }
      this.words = this.lines[this.next++].split(/[\s,]+/).filter((word) => word !== '');
      this.word = 0;
      this.line = this.next;
    }
    const word = this.words[this.word++];
    const value = Number(word);
    // the pattern is tested last: its time is quadratic in the length of malformed digits
    if (!Number.isFinite(value) || !/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(word)) {
      throw new IESError(this.line, `"${word.slice(0, QUOTED)}" is not a number; write ${what} there.`);
    }
    return value;
  }

  /** The next number, which must be whole. @throws IESError for other numbers, or ones outside of `least` to `most` */
  count(what: string, least: number, most: number): number {
    const value = this.number(what);
    if (!Number.isInteger(value) || value < least || value > most) {
      throw new IESError(this.line, `${what} is ${value}; write a whole number from ${least} to ${most}.`);
    }
    return value;
  }

  /** Reads the next numbers of the file. */
  numbers(count: number, what: string): Float64Array {
    const values = new Float64Array(count);
    for (let i = 0; i < count; i++) values[i] = this.number(what);
    return values;
  }

  /** The next numbers, each larger than the one before. @throws IESError where one is not */
  ascending(count: number, what: string): Float64Array {
    const values = new Float64Array(count);
    for (let i = 0; i < count; i++) {
      values[i] = this.number(what);
      if (i > 0 && values[i] <= values[i - 1]) {
        throw new IESError(this.line, `${what} go from ${values[i - 1]} to ${values[i]}; put them in ascending order.`);
      }
    }
    return values;
  }
}
