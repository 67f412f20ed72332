import { readNumber } from '@farol/editing';

/** Keys accepted in a number: characters of expressions, without units. */
const SIGNS = /^[\d.,+\-*/()]$/;

/** The properties of a keyboard event that are used. */
export interface TypedKey {
  readonly key: string;
  readonly shiftKey: boolean;
}

/**
 * Numbers typed during a drag, one for each axis: characters are appended to the current one, Backspace deletes, Tab
 * goes to the next axis.
 */
export class TypedAmounts {
  private readonly texts: string[];
  private current = 0;

  /** @param axes - number of axes, at least 1 */
  constructor(readonly axes: number) {
    this.texts = Array.from({ length: axes }, () => '');
  }

  /** Whether a number was typed, so that the pointer is ignored. */
  get isTyped(): boolean {
    return this.texts.some((text) => text !== '');
  }

  /** Index of the axis whose number is being typed. */
  get at(): number {
    return this.current;
  }

  /** Text typed for an axis. */
  textOf(axis: number): string {
    return this.texts[axis];
  }

  /** Whether the text for an axis is not a number, and cannot become one by typing more. */
  isWrong(axis: number): boolean {
    const read = readNumber(this.texts[axis]);
    return this.texts[axis] !== '' && read.problem !== null && !read.isIncomplete;
  }

  /** Number typed for an axis; null when there is none, or it is incomplete. */
  valueOf(axis: number): number | null {
    const read = readNumber(this.texts[axis]);
    if (this.texts[axis] === '' || read.problem !== null) return null;
    return read.valueFor(0);
  }

  /** Handles a key press. @returns whether the key was handled */
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
