import { readNumber } from '@farol/editing';

/** Keys that are taken for a number: those of expressions, without units. */
const SIGNS = /^[\d.,+\-*/()]$/;

/** The part of a key press that counts. */
export interface TypedKey {
  readonly key: string;
  readonly shiftKey: boolean;
}

/**
 * The numbers that are typed during a drag, one for each axis: digits and signs add to the one that is typed, Backspace
 * takes back, Tab goes to the next axis.
 */
export class TypedAmounts {
  private readonly texts: string[];
  private current = 0;

  /** @param axes - how many there are, at least 1 */
  constructor(readonly axes: number) {
    this.texts = Array.from({ length: axes }, () => '');
  }

  /** Whether anything is typed, so that the pointer does not count. */
  get isTyped(): boolean {
    return this.texts.some((text) => text !== '');
  }

  /** Index of the axis whose number is typed. */
  get at(): number {
    return this.current;
  }

  /** What is typed for an axis. */
  textOf(axis: number): string {
    return this.texts[axis];
  }

  /** Whether what is typed for an axis is no number, and does not become one by typing on. */
  isWrong(axis: number): boolean {
    const read = readNumber(this.texts[axis]);
    return this.texts[axis] !== '' && read.problem !== null && !read.isIncomplete;
  }

  /** The number of an axis; null where there is none, or none yet. */
  valueOf(axis: number): number | null {
    const read = readNumber(this.texts[axis]);
    if (this.texts[axis] === '' || read.problem !== null) return null;
    return read.valueFor(0);
  }

  /** Takes a key. @returns whether it means anything here */
  press({ key, shiftKey }: TypedKey): boolean {
    if (key === 'Backspace') {
      if (!this.isTyped) return true;
      if (this.texts[this.current] === '') this.current = Math.max(0, this.current - 1);
      this.texts[this.current] = this.texts[this.current].slice(0, -1);
      return true;
    }
    if (key === 'Tab') {
      this.current = (this.current + (shiftKey ? this.axes - 1 : 1)) % this.axes;
      return true;
    }
    if (!SIGNS.test(key)) return false;
    this.texts[this.current] += key;
    return true;
  }
}
