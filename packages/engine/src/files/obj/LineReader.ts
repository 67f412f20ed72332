const [TAB, LINE_FEED, RETURN, SPACE, PLUS, MINUS, POINT, SLASH, BACKSLASH] = [9, 10, 13, 32, 43, 45, 46, 47, 92];
const [ZERO, NINE, UPPER_E, LOWER_E] = [48, 57, 69, 101];

/**
 * Greatest number of decimal digits for which a double holds mantissa and power of ten exactly, so that their quotient
 * is correctly rounded.
 */
const DIGITS = 15;
const POWERS = 22;

const isDigit = (byte: number): boolean => byte >= ZERO && byte <= NINE;

/**
 * Reads a text file line by line, without a string for each line: words, numbers and the rest of a line. A backslash at
 * the end of a line joins it with the next one, as in OBJ files.
 */
export class LineReader {
  /** Number of the current line, from 1. */
  line = 1;
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {
    // skips a byte order mark of UTF-8
    if (bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf) this.at = 3;
  }

  get isAtEnd(): boolean {
    return this.at >= this.bytes.length;
  }

  /** Skips blanks. @returns whether the line ends after them */
  get isLineOver(): boolean {
    this.skipBlanks();
    const byte = this.bytes[this.at];
    return byte === undefined || byte === LINE_FEED || byte === RETURN || byte === 0;
  }

  /** Goes to the start of the next line. */
  nextLine(): void {
    const { bytes } = this;
    let { at } = this;
    while (at < bytes.length && bytes[at] !== LINE_FEED && bytes[at] !== RETURN) {
      at = bytes[at] === BACKSLASH ? this.joined(at) : at + 1;
    }
    this.at = this.afterBreak(at);
    this.line++;
  }

  /** The letters up to the next blank; '' at the end of the line. */
  word(): string {
    if (this.isLineOver) return '';
    const start = this.at;
    while (!this.isBlank(this.bytes[this.at])) this.at++;
    return String.fromCharCode(...this.bytes.subarray(start, Math.min(this.at, start + 64)));
  }

  /** Rest of the line, without blanks at its ends. */
  rest(): string {
    this.skipBlanks();
    const start = this.at;
    const { bytes } = this;
    while (this.at < bytes.length && bytes[this.at] !== LINE_FEED && bytes[this.at] !== RETURN) this.at++;
    return new TextDecoder().decode(bytes.subarray(start, this.at)).trim();
  }

  /** Next word as a decimal number; NaN for any other word. */
  number(): number {
    this.skipBlanks();
    const { bytes } = this;
    let { at } = this;
    const start = at;
    const isNegative = bytes[at] === MINUS;
    if (isNegative || bytes[at] === PLUS) at++;
    let mantissa = 0;
    let exponent = 0;
    let digits = 0;
    let read = 0;
    for (let isFraction = false; ; at++) {
      const byte = bytes[at];
      if (byte === POINT && !isFraction) {
        isFraction = true;
      } else if (isDigit(byte)) {
        read++;
        mantissa = mantissa * 10 + (byte - ZERO);
        if (mantissa > 0) digits++;
        if (isFraction) exponent--;
      } else break;
    }
    if (read > 0 && (bytes[at] === LOWER_E || bytes[at] === UPPER_E)) {
      this.at = at + 1;
      exponent += this.integer();
      ({ at } = this);
    }
    this.at = at;
    if (read === 0 || !this.isBlank(bytes[at])) {
      while (!this.isBlank(bytes[this.at])) this.at++;
      return NaN;
    }
    if (digits > DIGITS || Math.abs(exponent) > POWERS) {
      return Number(String.fromCharCode(...bytes.subarray(start, Math.min(at, start + 1024))));
    }
    const value = exponent < 0 ? mantissa / 10 ** -exponent : mantissa * 10 ** exponent;
    return isNegative ? -value : value;
  }

  /** Integer with optional sign at the current position; NaN when there is none. */
  integer(): number {
    const { bytes } = this;
    const isNegative = bytes[this.at] === MINUS;
    if (isNegative || bytes[this.at] === PLUS) this.at++;
    const start = this.at;
    let value = 0;
    while (isDigit(bytes[this.at])) value = value * 10 + (bytes[this.at++] - ZERO);
    if (this.at === start) return NaN;
    return isNegative ? -value : value;
  }

  /** Skips a slash; false if the next character is another one. */
  slash(): boolean {
    if (this.bytes[this.at] !== SLASH) return false;
    this.at++;
    return true;
  }

  /** Whether a blank, or the end of the line, is next. */
  get isWordOver(): boolean {
    return this.isBlank(this.bytes[this.at]);
  }

  private skipBlanks(): void {
    const { bytes } = this;
    for (;;) {
      const byte = bytes[this.at];
      if (byte === SPACE || byte === TAB) this.at++;
      else if (byte === BACKSLASH) {
        const next = this.joined(this.at);
        if (next === this.at + 1) return;
        this.at = next;
      } else return;
    }
  }

  private isBlank(byte: number | undefined): boolean {
    return byte === undefined || byte === SPACE || byte === TAB || byte === LINE_FEED || byte === RETURN || byte === 0;
  }

  /**
   * Offset at which the text continues after a backslash: the start of the next line if the backslash ends this one.
   */
  private joined(backslash: number): number {
    const next = this.bytes[backslash + 1];
    if (next !== LINE_FEED && next !== RETURN) return backslash + 1;
    this.line++;
    return this.afterBreak(backslash + 1);
  }

  /** The start of the line after a line break, which is a line feed, a return, or both. */
  private afterBreak(at: number): number {
    return at + (this.bytes[at] === RETURN && this.bytes[at + 1] === LINE_FEED ? 2 : 1);
  }
}
